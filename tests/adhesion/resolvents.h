// SPDX-License-Identifier: LGPL-2.1-or-later
// The point laws the resolvent tests try, and the law they must fulfil.
#ifndef demold_tests_adhesion_resolvents_h
#define demold_tests_adhesion_resolvents_h

#include "adhesion/traction_resolvent.h"

#include "bonds.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace demold
{
  constexpr double alpha = 0.2, delta = 0.1, decay = 0.03;

  enum class Curve
  {
    linear,
    exponential
  };

  /// Rigid onset, strength alpha, gap delta (linear) or decay (exponential).
  inline TractionResolvent make_resolvent(const Curve      curve,
                                          const ModeMixing mixing,
                                          const double     friction,
                                          const double     penalty_over_slope)
  {
    const Softening softening =
      curve == Curve::linear ?
        Softening(LinearSoftening{alpha, delta, 1e3}) :
        Softening(ExponentialSoftening{alpha, decay, 1e3});
    TractionResolvent law;
    law.adhesion = make_bond(rigid_softening(softening), mixing);
    law.friction = friction;
    law.penalty  = penalty_over_slope * law.smallest_penalty() / 5.;
    return law;
  }

  /// Twice alpha/delta suffices for uniqueness; 5 is the least the program
  /// takes.
  inline std::vector<TractionResolvent> all_resolvents()
  {
    std::vector<TractionResolvent> laws;
    for (const Curve curve : {Curve::linear, Curve::exponential})
      for (const ModeMixing mixing : all_mixings)
        for (const double friction : {0., 0.4})
          for (const double ratio : {2., 5., 80.})
            laws.push_back(make_resolvent(curve, mixing, friction, ratio));
    return laws;
  }

  /// s [MPa] in closed form, theory C1 and C.6; 0 once separated.
  inline double tension_limit(const TractionResolvent &law, const double kappa)
  {
    if (kappa >= law.adhesion->rupture_gap() * (1. - 1e-9))
      return 0.;
    return std::holds_alternative<LinearSoftening>(law.adhesion->softening) ?
             alpha * (1. - kappa / delta) :
             alpha * std::exp(-kappa / decay);
  }

  inline double effective_gap(const TractionResolvent &law,
                              const double             opening,
                              const Vector3           &slip)
  {
    return std::hypot(std::max(opening, 0.), law.factors().b * slip.norm());
  }

  /// A point and a normal.
  struct ResolventSample
  {
    Vector3           normal;
    AugmentedTraction traction;
    ResolventState    old;
  };

  inline double uniform(std::mt19937 &engine, const double a, const double b)
  {
    return std::uniform_real_distribution<double>(a, b)(engine);
  }

  /// Where damage is spread over, and tractions: up to the cut of the
  /// exponential law as well as over its first lengths.
  inline double random_reach(const TractionResolvent &law, std::mt19937 &engine)
  {
    const double reach = law.adhesion->rupture_gap();
    return uniform(engine, 0., 1.) < .3 ? reach : std::min(reach, 3. * decay);
  }

  /// Intact, damaged by opening or by slip, separated, or never bonded.
  inline ResolventState random_state(const TractionResolvent &law,
                                     const Vector3           &normal,
                                     std::mt19937            &engine)
  {
    const double   kind = uniform(engine, 0., 1.);
    ResolventState old  = law.fresh_bond();
    old.may_stick       = uniform(engine, 0., 1.) < .8;
    old.friction_limit  = uniform(engine, 0., .1);
    if (uniform(engine, 0., 1.) < .3)
      old.bond.strength_factor = 0.6;
    if (kind < .1)
      old.bonded = false;
    else if (kind < .25)
      old.bond.kappa = law.adhesion->rupture_gap();
    else if (kind < .75)
      {
        old.bond.kappa = uniform(engine, 1e-4, 1.) *
                         std::min(random_reach(law, engine),
                                  law.adhesion->rupture_gap() * .999);
        const double angle = uniform(engine, 0., std::acos(0.));
        const double size  = uniform(engine, 0., 1.) < .3 ?
                               old.bond.kappa :
                               uniform(engine, 0., 1.) * old.bond.kappa;
        const bool   slid  = uniform(engine, 0., 1.) < .5;
        old.opening        = slid ? 0. : size * std::cos(angle);
        old.slip = size * (slid ? 1. : std::sin(angle)) / law.factors().b *
                   random_tangent(normal, engine);
      }
    return old;
  }

  /// Tractions of all sizes around those that separate.
  inline AugmentedTraction random_traction(const TractionResolvent &law,
                                           const Vector3           &normal,
                                           std::mt19937            &engine)
  {
    const double scale =
      uniform(engine, 0., 1.) < .4 ?
        2. * alpha :
        1.2 * (alpha + law.penalty * random_reach(law, engine));
    const double ratio = law.factors().a / law.factors().b;
    const double angle = uniform(engine, 0., 2. * std::acos(0.));
    const double size  = uniform(engine, 0., 1.) * scale;
    return {size * std::cos(angle),
            size * std::sin(angle) * ratio * random_tangent(normal, engine)};
  }

  inline ResolventSample random_sample(const TractionResolvent &law,
                                       std::mt19937            &engine)
  {
    ResolventSample s;
    s.normal   = random_direction(engine);
    s.old      = random_state(law, s.normal, engine);
    s.traction = random_traction(law, s.normal, engine);
    if (uniform(engine, 0., 1.) < .3)
      // About where an unchanged slip puts the point.
      s.traction.tangential =
        uniform(engine, .7, 1.3) * law.tangential_penalty() * s.old.slip +
        uniform(engine, 0., 2.) * alpha * random_tangent(s.normal, engine);
    return s;
  }

  /// lambda [MPa].
  inline AugmentedTraction multiplier(const TractionResolvent &law,
                                      const AugmentedTraction &traction,
                                      const ResolventResponse &r)
  {
    return {traction.normal - law.penalty * r.gap_N,
            traction.tangential - law.tangential_penalty() * r.gap_T};
  }

  /// By how much [MPa] a response misses the law of theory C.4: contact,
  /// Coulomb's friction and adhesion in parallel, from the multiplier, the gap
  /// and the history before, without any case of the table.
  inline double law_violation(const TractionResolvent &law,
                              const ResolventSample   &s,
                              const ResolventResponse &r)
  {
    const auto   lambda = multiplier(law, s.traction, r);
    const double a = law.factors().a, b = law.factors().b;
    const bool   bonded = law.holds(s.old);
    const double kappa =
      bonded ?
        std::max(s.old.bond.kappa, effective_gap(law, r.gap_N, r.gap_T)) :
        law.adhesion->rupture_gap();
    const double limit = s.old.bond.strength_factor * tension_limit(law, kappa);
    const double pressure = std::max(-lambda.normal, 0.);
    const double grip     = s.old.may_stick ? law.friction * pressure : 0.;

    double worst = std::max(-law.penalty * r.gap_N, 0.);
    if (kappa == 0.)
      return std::max(
        worst,
        std::hypot(std::max(lambda.normal, 0.),
                   b / a * std::max(lambda.tangential.norm() - grip, 0.)) -
          limit);

    const double  stiffness = limit / kappa;
    const double  contact   = lambda.normal - stiffness * r.gap_N;
    const Vector3 rubbing   = lambda.tangential - a * stiffness * r.gap_T;
    const Vector3 slide     = r.gap_T - s.old.slip;
    worst                   = std::max(worst, contact);
    if (r.gap_N > 0.)
      worst = std::max(worst, std::abs(contact));
    worst = std::max(worst, rubbing.norm() - grip);
    if (slide.norm() > 0.)
      worst = std::max(worst, (rubbing - grip * slide / slide.norm()).norm());
    return worst;
  }
} // namespace demold

#endif

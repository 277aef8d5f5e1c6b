// SPDX-License-Identifier: LGPL-2.1-or-later
// The gap that belongs to an augmented traction fulfils the law of contact,
// friction and adhesion on every branch, and there is one of it.
#include "adhesion/traction_resolvent.h"

#include "resolvents.h"

#include <gtest/gtest.h>

#include <map>

namespace demold
{
  using namespace dealii;

  using Reached =
    std::map<std::pair<AdhesionStatus, ContactStatus>, unsigned int>;

  // Every pair of states there is but adhering and sliding.
  void expect_all_reached(const Reached     &reached,
                          const bool         friction,
                          const unsigned int at_least)
  {
    using A = AdhesionStatus;
    using C = ContactStatus;
    for (const A bond :
         {A::adhering, A::decohesion, A::unloading, A::separated})
      for (const C contact : {C::open, C::closed, C::slip})
        {
          const bool possible =
            contact == C::slip ? friction && bond != A::adhering : true;
          const auto         found = reached.find({bond, contact});
          const unsigned int n = found == reached.end() ? 0u : found->second;
          if (possible)
            EXPECT_GE(n, at_least) << int(bond) << " with " << int(contact);
          else
            EXPECT_EQ(n, 0u) << int(bond) << " with " << int(contact);
        }
  }



  // What the direction of a slide much smaller than the slip is worth [MPa].
  double round_off_of_slide(const TractionResolvent &law,
                            const ResolventSample   &s,
                            const ResolventResponse &r)
  {
    const double slide = (r.gap_T - s.old.slip).norm();
    return slide > 0. ? 1e-15 * s.old.slip.norm() / slide * law.friction *
                          std::abs(s.traction.normal) :
                        0.;
  }



  TEST(traction_resolvent, gap_fulfils_the_law)
  {
    std::mt19937 engine(1);
    for (const bool friction : {false, true})
      {
        Reached reached;
        for (const TractionResolvent &law : all_resolvents())
          if ((law.friction > 0.) == friction)
            for (unsigned int i = 0; i < 3000; ++i)
              {
                const auto s = random_sample(law, engine);
                const auto r = law.evaluate(s.traction, s.old);
                ++reached[{r.bond, r.contact}];
                const double size = std::abs(s.traction.normal) +
                                    s.traction.tangential.norm() + alpha;
                ASSERT_LT(law_violation(law, s, r),
                          1e-12 * size + round_off_of_slide(law, s, r))
                  << int(r.bond) << " " << int(r.contact) << " "
                  << s.old.bond.kappa;
                ASSERT_TRUE(r.consistent);
                ASSERT_NEAR(r.gap_T * s.normal,
                            0.,
                            1e-13 * size / law.tangential_penalty());
              }
        expect_all_reached(reached, friction, 100);
      }
  }



  // Distance of two points in the scaled spaces in which the map is radial:
  // (lambda_hat_N, b/a lambda_hat_T) and (g_N, b g_T).
  double traction_distance(const TractionResolvent &law,
                           const AugmentedTraction &x,
                           const AugmentedTraction &y)
  {
    return std::hypot(x.normal - y.normal,
                      law.factors().b / law.factors().a *
                        (x.tangential - y.tangential).norm());
  }



  double gap_distance(const TractionResolvent &law,
                      const ResolventResponse &x,
                      const ResolventResponse &y)
  {
    return std::hypot(x.gap_N - y.gap_N,
                      law.factors().b * (x.gap_T - y.gap_T).norm());
  }



  // C8: 1/(c_N - steepest softening). Friction, which is no gradient, adds a
  // row mu to it: dg_T/dlambda_hat_N. The exponential law, cut at 1e-6 of its
  // strength, jumps by that over c_N.
  struct LipschitzBound
  {
    double slope;
    double jump;
  };

  LipschitzBound lipschitz_bound(const TractionResolvent &law)
  {
    const double least = law.smallest_penalty() / 5.;
    const double mu    = law.friction * law.factors().b / law.factors().a;
    const bool   cut =
      std::holds_alternative<ExponentialSoftening>(law.adhesion->softening);
    return {std::hypot(1., mu) / (law.penalty - least),
            (cut ? 2e-6 : 1e-8) * alpha / law.penalty};
  }



  TEST(traction_resolvent, gap_depends_on_traction_without_jumps)
  {
    std::mt19937 engine(2);
    for (const TractionResolvent &law : all_resolvents())
      {
        const LipschitzBound bound = lipschitz_bound(law);
        double               worst = 0.;
        for (unsigned int i = 0; i < 3000; ++i)
          {
            const auto        s     = random_sample(law, engine);
            AugmentedTraction other = random_traction(law, s.normal, engine);
            const double      near  = std::pow(10., uniform(engine, -6., 0.));
            other.normal            = s.traction.normal + near * other.normal;
            other.tangential = s.traction.tangential + near * other.tangential;
            const double distance = traction_distance(law, s.traction, other);
            const double moved    = gap_distance(law,
                                              law.evaluate(s.traction, s.old),
                                              law.evaluate(other, s.old));
            ASSERT_LE(moved, bound.slope * distance * (1. + 1e-9) + bound.jump);
            worst = std::max(worst, moved / (bound.slope * distance));
          }
        // Sharp for the linear law, whose slope is the same all along.
        if (std::holds_alternative<LinearSoftening>(law.adhesion->softening) &&
            law.friction == 0.)
          {
            EXPECT_GT(worst, .99);
          }
      }
  }



  TEST(traction_resolvent, branches_meet_at_their_borders)
  {
    std::mt19937 engine(3);
    using State = std::pair<AdhesionStatus, ContactStatus>;
    std::map<std::pair<State, State>, unsigned int> borders;
    for (const TractionResolvent &law : all_resolvents())
      for (unsigned int i = 0; i < 1000; ++i)
        {
          const auto        s     = random_sample(law, engine);
          AugmentedTraction in    = s.traction;
          AugmentedTraction out   = random_traction(law, s.normal, engine);
          const auto        state = [&](const AugmentedTraction &t) -> State {
            const auto r = law.evaluate(t, s.old);
            return {r.bond, r.contact};
          };
          const State inside = state(in);
          if (inside == state(out))
            continue;
          for (unsigned int k = 0; k < 60; ++k)
            {
              const AugmentedTraction middle{.5 * (in.normal + out.normal),
                                             .5 * (in.tangential +
                                                   out.tangential)};
              (state(middle) == inside ? in : out) = middle;
            }
          const double size = std::abs(in.normal) + in.tangential.norm();
          const auto   r    = law.evaluate(in, s.old);
          const auto   q    = law.evaluate(out, s.old);
          ++borders[{std::min(inside, state(out)),
                     std::max(inside, state(out))}];
          ASSERT_LE(gap_distance(law, r, q),
                    lipschitz_bound(law).jump +
                      1e-12 * size * lipschitz_bound(law).slope)
            << int(r.bond) << int(r.contact) << int(q.bond) << int(q.contact);
        }
    EXPECT_GE(borders.size(), 17u);
  }
} // namespace demold

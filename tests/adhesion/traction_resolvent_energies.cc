// SPDX-License-Identifier: LGPL-2.1-or-later
// What the point law loses is the work done on it less what it stores.
#include "resolvent_paths.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>

namespace demold
{
  using namespace dealii;

  // Frictionless, all mixings, both curves.
  std::vector<TractionResolvent> all_bonded_laws()
  {
    std::vector<TractionResolvent> laws;
    for (const Curve curve : {Curve::linear, Curve::exponential})
      for (const ModeMixing mixing : all_mixings)
        laws.push_back(make_resolvent(curve, mixing, 0., 5.));
    return laws;
  }



  // Integral of traction times d(gap) from one gap straight to another.
  double work_along(const TractionResolvent &law,
                    const Gap               &from,
                    const Gap               &to,
                    const double             kappa_old)
  {
    const auto power = [&](const double fraction) {
      const auto t =
        bond_traction(law, between(from, to, fraction), kappa_old, to);
      return t.normal * (to.opening - from.opening) +
             t.tangential * (to.slip - from.slip);
    };
    // Pieces between the kinks: where loading begins, and rupture.
    const auto crossing = [&](const double kappa) {
      double a = 0., b = 1.;
      for (unsigned int i = 0; i < 60; ++i)
        {
          const double middle = .5 * (a + b);
          (effective_gap(law, between(from, to, middle)) < kappa ? a : b) =
            middle;
        }
      return b;
    };
    const std::vector<double> ends{0.,
                                   crossing(kappa_old),
                                   crossing(law.adhesion->rupture_gap()),
                                   1.};
    double                    sum = 0.;
    // Adaptive, as modes turn fast where the path comes near no gap at all.
    for (unsigned int i = 0; i + 1 < ends.size(); ++i)
      if (ends[i + 1] > ends[i])
        sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
          power,
          ends[i],
          ends[i + 1],
          8,
          1e-11);
    return sum;
  }



  Gap random_gap(const TractionResolvent &law, std::mt19937 &engine)
  {
    const double reach = 1.1 * std::min(law.adhesion->rupture_gap(), delta);
    const double c     = std::cos(uniform(engine, 0., 2. * std::acos(0.)));
    const double size  = reach * uniform(engine, 0., 1.);
    return {std::max(size * c, 0.),
            size * std::sqrt(1. - c * c) * random_tangent(up, engine)};
  }



  TEST(traction_resolvent_energies, work_of_separation_is_that_of_the_mixing)
  {
    for (const TractionResolvent &law : all_bonded_laws())
      for (const double angle : {0., .3, .8, 1.2, std::acos(0.)})
        for (const unsigned int steps : {1u, 4u, 40u})
          {
            const double reach = 1.01 * law.adhesion->rupture_gap() /
                                 std::min(1., law.factors().b);
            const Gap      end{reach * std::cos(angle),
                          reach * std::sin(angle) * vector(.6, .8, 0.)};
            ResolventState state = law.fresh_bond();
            double         work  = 0.;
            for (unsigned int i = 0; i < steps; ++i)
              {
                const Gap next = between({0., {}}, end, (i + 1.) / steps);
                work += work_along(law,
                                   {state.opening, state.slip},
                                   next,
                                   state.bond.kappa);
                state = lead_to(law, next, 0., state).state;
                if (!law.holds(state))
                  break;
              }
            const double c = std::pow(std::cos(angle), 2);
            const double s = std::pow(std::sin(angle), 2);
            const double a = law.factors().a, b = law.factors().b;
            const double G_c =
              std::holds_alternative<LinearSoftening>(law.adhesion->softening) ?
                .5 * alpha * delta :
                alpha * decay * (1. - ExponentialSoftening::residual_limit);
            const double expected = G_c * (c + a * s) / (c + b * b * s);
            EXPECT_NEAR(state.bond.dissipated, expected, 1e-12);
            // The last bit of the exponential law is lost at the cut.
            EXPECT_NEAR(work, expected, 1e-7 * G_c);
          }
  }



  TEST(traction_resolvent_energies, loss_is_work_less_stored_in_every_step)
  {
    std::mt19937 engine(11);
    unsigned int softened = 0;
    for (const TractionResolvent &law : all_bonded_laws())
      for (unsigned int path = 0; path < 60; ++path)
        {
          ResolventState state  = law.fresh_bond();
          double         stored = 0., work = 0.;
          for (unsigned int step = 0; step < 12; ++step)
            {
              const Gap start{state.opening, state.slip};
              // The last step closes the path.
              const Gap end = step < 11 ? random_gap(law, engine) : Gap{0., {}};
              if (effective_gap(law, end) >= .999 * law.adhesion->rupture_gap())
                continue;
              const double done = work_along(law, start, end, state.bond.kappa);
              const auto   r =
                lead_to(law, end, end.opening > 0. ? 0. : .05, state);
              work += done;
              ASSERT_NEAR(r.dissipated_increment,
                          done - (r.stored - stored),
                          1e-15);
              ASSERT_GE(r.dissipated_increment, -1e-16);
              ASSERT_EQ(r.friction_increment, 0.);
              softened += r.bond == AdhesionStatus::decohesion;
              stored = r.stored;
              state  = r.state;
            }
          ASSERT_NEAR(stored, 0., 1e-30);
          ASSERT_NEAR(state.bond.dissipated, work, 1e-14);
        }
    EXPECT_GT(softened, 1000u);
  }



  TEST(traction_resolvent_energies, loss_does_not_depend_on_steps)
  {
    for (const TractionResolvent &law : all_bonded_laws())
      {
        // Opened first, then sheared: modes change while damage grows.
        const Gap opened{.02, {}};
        const Gap sheared{.02, .03 * vector(1., 0., 0.)};
        double    first = 0.;
        for (const unsigned int steps : {1u, 4u, 40u})
          {
            ResolventState state =
              lead_to(law, opened, 0., law.fresh_bond()).state;
            for (unsigned int i = 0; i < steps; ++i)
              state = lead_to(law,
                              between(opened, sheared, (i + 1.) / steps),
                              0.,
                              state)
                        .state;
            EXPECT_NEAR(state.bond.kappa, effective_gap(law, sheared), 1e-13);
            if (steps == 1)
              first = state.bond.dissipated;
            EXPECT_NEAR(state.bond.dissipated, first, 1e-14);
          }
      }
  }



  TEST(traction_resolvent_energies, linear_loss_is_half_strength_times_damage)
  {
    const auto law = make_resolvent(Curve::linear, ModeMixing::energy, 0., 5.);
    ResolventState state = law.fresh_bond();
    for (const double opening : {.01, .05, .02, .03, .08})
      {
        const double before = state.bond.kappa;
        const auto   r      = lead_to(law, {opening, {}}, 0., state);
        state               = r.state;
        const double damage = std::max(before, opening);
        EXPECT_NEAR(r.path_increment, .5 * alpha * (damage - before), 1e-16);
        EXPECT_NEAR(state.bond.dissipated, .5 * alpha * damage, 1e-15);
        EXPECT_NEAR(r.stored,
                    .5 * alpha * (1. / damage - 1. / delta) * opening * opening,
                    1e-16);
      }
  }



  TEST(traction_resolvent_energies, friction_loses_limit_times_slip)
  {
    for (const ModeMixing mixing : all_mixings)
      {
        const auto law = make_resolvent(Curve::linear, mixing, .4, 5.);
        // To and fro under a pressure that grows with the way: by hand,
        // mu times integral of pressure over the way, beside the bond's loss.
        ResolventState state = law.fresh_bond();
        state.friction_limit = law.friction * .1;
        const Vector3 e      = vector(.6, -.8, 0.);
        double        way = 0., slip = 0., bond = 0.;
        for (const double step : {.01, .02, -.015, -.03, .04, -.025})
          {
            const double kappa = state.bond.kappa;
            const Gap    from{0., state.slip};
            slip += step;
            way += std::abs(step);
            bond += work_along(law, from, {0., slip * e}, kappa);
            const auto r = lead_to(law, {0., slip * e}, .1 + 2. * way, state);
            EXPECT_EQ(r.contact, ContactStatus::slip);
            state = r.state;
          }
        EXPECT_NEAR(slip, 0., 1e-15);
        EXPECT_NEAR(state.friction_loss,
                    law.friction * (.1 * way + way * way),
                    1e-14);
        EXPECT_NEAR(state.bond.dissipated, bond, 1e-13);
      }
  }
} // namespace demold

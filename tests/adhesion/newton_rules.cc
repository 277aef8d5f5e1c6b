// SPDX-License-Identifier: LGPL-2.1-or-later
// The Newton rules of theory C.4 act as written, and with them a point on
// springs finds its state whatever the increment.
#include "adhesion/newton_rules.h"

#include "resolvents.h"

#include <gtest/gtest.h>

namespace demold
{
  using namespace dealii;

  const Vector3 e_x = vector(1., 0., 0.);

  TEST(newton_rules, sliding_starts_with_sticking)
  {
    const auto law = make_resolvent(Curve::linear, ModeMixing::energy, .4, 5.);
    ResolventState old;
    old.may_stick = true;
    const AugmentedTraction t{-1., e_x};
    const NewtonMemory      start;
    const auto              first = evaluate_by_rules(law, t, old, start);
    EXPECT_EQ(first.contact, ContactStatus::closed);
    EXPECT_FALSE(first.consistent);
    const auto second = evaluate_by_rules(law, t, old, start.after(first));
    EXPECT_EQ(second.contact, ContactStatus::slip);
    EXPECT_TRUE(second.consistent);
  }



  TEST(newton_rules, no_bond_separates_without_softening_first)
  {
    const auto law = make_resolvent(Curve::linear, ModeMixing::energy, .4, 5.);
    ResolventState damaged = law.fresh_bond();
    damaged.bond.kappa     = .3 * delta;
    for (const double normal : {10., -.01})
      for (const ResolventState &old : {law.fresh_bond(), damaged})
        {
          const AugmentedTraction t{normal, 10. * e_x};
          EXPECT_EQ(law.evaluate(t, old).bond, AdhesionStatus::separated);
          NewtonMemory memory;
          memory.iteration = 1;
          const auto first = evaluate_by_rules(law, t, old, memory);
          EXPECT_EQ(first.bond, AdhesionStatus::decohesion);
          EXPECT_FALSE(first.consistent);
          // The curve goes on beyond rupture, so the gap does too.
          EXPECT_GT(std::hypot(first.gap_N,
                               law.factors().b * first.gap_T.norm()),
                    delta);
          memory            = memory.after(first);
          const auto second = evaluate_by_rules(law, t, old, memory);
          EXPECT_EQ(second.bond, AdhesionStatus::separated);
          EXPECT_TRUE(second.consistent);
        }
  }



  TEST(newton_rules, slide_that_turns_round_stops_once)
  {
    TractionResolvent law;
    law.friction = .4;
    law.penalty  = 10.;
    ResolventState old;
    old.may_stick = true;
    NewtonMemory memory;
    memory.iteration = 1;
    memory = memory.after(evaluate_by_rules(law, {-1., e_x}, old, memory));
    EXPECT_EQ(memory.contact, ContactStatus::slip);
    // 80 degrees pass, 100 do not.
    const auto turned = [](const double degrees) {
      const double radians = degrees * std::acos(-1.) / 180.;
      return vector(std::cos(radians), std::sin(radians), 0.);
    };
    EXPECT_EQ(evaluate_by_rules(law, {-1., turned(80.)}, old, memory).contact,
              ContactStatus::slip);
    const auto stopped =
      evaluate_by_rules(law, {-1., turned(100.)}, old, memory);
    EXPECT_EQ(stopped.contact, ContactStatus::closed);
    EXPECT_FALSE(stopped.consistent);
    EXPECT_EQ(
      evaluate_by_rules(law, {-1., turned(100.)}, old, memory.after(stopped))
        .contact,
      ContactStatus::slip);
  }



  // A point held by springs to a support at u: lambda = K (u - g), all of it
  // found by semi-smooth Newton on g = G(lambda + C g), theory C9.
  struct SpringResult
  {
    bool              converged  = false;
    unsigned int      iterations = 0;
    ResolventResponse response;
  };

  SpringResult solve_spring(const TractionResolvent &law,
                            const double             stiffness,
                            const Vector3           &support,
                            const ResolventState    &old)
  {
    Vector3      g = old.slip + old.opening * up;
    NewtonMemory memory;
    SpringResult result;
    for (; result.iterations < 40; ++result.iterations)
      {
        const Vector3 lambda   = stiffness * (support - g);
        const Vector3 g_T      = g - (g * up) * up;
        const Vector3 l_T      = lambda - (lambda * up) * up;
        const auto    r        = evaluate_by_rules(law,
                                         {lambda * up + law.penalty * (g * up),
                                                    l_T + law.tangential_penalty() * g_T},
                                         old,
                                         memory);
        const Vector3 residual = g - r.gap_T - r.gap_N * up;
        result.response        = r;
        if (r.consistent && residual.norm() < 1e-13)
          {
            result.converged = true;
            break;
          }
        Tensor<2, 3> within, J;
        within[0][0] = within[1][1] = 1.;
        const Tensor<2, 3> C        = law.penalty * outer_product(up, up) +
                               law.tangential_penalty() * within;
        Tensor<2, 3>       one = within + outer_product(up, up);
        const Tensor<2, 3> slope =
          within * r.dT_dT * within + outer_product(r.dT_dN, up) +
          outer_product(up, r.dN_dT) + r.dN_dN * outer_product(up, up);
        J = one - slope * (C - stiffness * one);
        g -= invert(J) * residual;
        memory = memory.after(r);
      }
    return result;
  }



  TEST(newton_rules, spring_finds_its_state_in_any_increment)
  {
    std::mt19937 engine(41);
    unsigned int solved = 0, iterations = 0, most = 0;
    for (const TractionResolvent &law : all_resolvents())
      {
        // Stiffer than the bond softens in both directions: one solution.
        const double stiffness =
          2. * law.smallest_penalty() / 5. * std::max(1., law.factors().a);
        for (unsigned int path = 0; path < 20; ++path)
          {
            ResolventState state = law.fresh_bond();
            for (unsigned int step = 0; step < 10 && law.holds(state); ++step)
              {
                const double  size    = 1.5 * delta * uniform(engine, 0., 1.);
                const Vector3 support = size * random_direction(engine);
                const auto    result =
                  solve_spring(law, stiffness, support, state);
                ASSERT_TRUE(result.converged)
                  << int(result.response.bond) << " "
                  << int(result.response.contact);
                ++solved;
                iterations += result.iterations;
                most  = std::max(most, result.iterations);
                state = result.response.state;
              }
          }
      }
    EXPECT_GT(solved, 2000u);
    EXPECT_LT(most, 15u);
    EXPECT_LT(double(iterations) / solved, 6.);
  }
} // namespace demold

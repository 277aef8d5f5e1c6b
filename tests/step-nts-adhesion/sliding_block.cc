// SPDX-License-Identifier: LGPL-2.1-or-later
// sliding-block.prm: friction, adhesion and both, theory C.2 and C.3.
#include "step-nts-adhesion/run_nts.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double area = 100., pressure = .1;       // [mm^2], [MPa]
    constexpr double friction = .3 * pressure * area;  // mu N [N]
    constexpr double bond     = .5 * .2 * area;        // beta_T alpha A
    constexpr double fracture = .5 * .2 * .1 * area;   // G_c A [mJ]
    constexpr double creep    = .3 * pressure / 1000.; // mu p/c_T [mm]
  }                                                    // namespace

  TEST(SlidingBlock, sticks_until_friction_and_bond_are_both_exhausted)
  {
    const SceneRun run = run_nts("sliding-block.prm");
    EXPECT_EQ(run.status(), "completed");
    EXPECT_NEAR(run.number("peak force [N]"),
                friction + bond,
                1e-3 * (friction + bond));
    EXPECT_NEAR(run.number("force at end [N]"), friction, 1e-6 * friction);
    EXPECT_NEAR(run.number("adhesion dissipation [mJ]"),
                fracture,
                1e-6 * fracture);
    EXPECT_NEAR(run.number("friction dissipation [mJ]"),
                friction * (1. - creep),
                1e-5 * friction);
    EXPECT_LT(run.number("energy balance error [-]"), 2e-3);
  }

  TEST(SlidingBlock, rubs_with_mu_N_alone_without_a_bond)
  {
    const SceneRun run = run_nts("sliding-block.prm", {"Adhesion/law=none"});
    EXPECT_NEAR(run.number("peak force [N]"), friction, 1e-6 * friction);
    EXPECT_NEAR(run.number("force at end [N]"), friction, 1e-6 * friction);
    EXPECT_NEAR(run.number("friction dissipation [mJ]"),
                friction * (1. - creep),
                1e-5 * friction);
    EXPECT_EQ(run.number("adhesion dissipation [mJ]"), 0.);
  }

  TEST(SlidingBlock, shears_off_the_bond_alone_without_friction)
  {
    const SceneRun run =
      run_nts("sliding-block.prm", {"Friction/coefficient=0"});
    EXPECT_NEAR(run.number("peak force [N]"), bond, 1e-3 * bond);
    EXPECT_NEAR(run.number("force at end [N]"), 0., 1e-9 * bond);
    EXPECT_NEAR(run.number("adhesion dissipation [mJ]"),
                fracture,
                1e-6 * fracture);
    EXPECT_EQ(run.number("friction dissipation [mJ]"), 0.);
    EXPECT_LT(run.number("energy balance error [-]"), 2e-3);
  }

  TEST(SlidingBlock, closes_the_ledger_when_it_is_of_rubber)
  {
    // A weak, long bond: the block shears off without a jump. Pressed by 5 %,
    // as the travel of the rigid block would hardly press rubber.
    const SceneRun run = run_nts("sliding-block.prm",
                                 {"Supports/driven=top xy",
                                  "Supports/motion y=-0.1*min(t, 1)",
                                  "Adhesion/strength=0.02",
                                  "Adhesion/rupture gap=0.2"});
    EXPECT_EQ(run.status(), "completed");
    EXPECT_GT(run.number("adhesion dissipation [mJ]"), .15); // of 0.2
    EXPECT_GT(run.number("friction dissipation [mJ]"), 1.);
    EXPECT_LT(run.number("energy balance error [-]"), .01);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// sliding-block.prm: friction, adhesion and both, without any creep before
// (theory C.4).
#include "step-mortar/run_mortar.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double area = 100., pressure = .1;      // [mm^2], [MPa]
    constexpr double friction = .3 * pressure * area; // mu N [N]
    constexpr double bond     = .5 * .2 * area;       // beta_T alpha A [N]
    constexpr double fracture = .5 * .2 * .1 * area;  // G_c A [mJ]
    constexpr double step     = .002;                 // [mm] in an increment

    class SlidingBlock : public Multipliers
    {};
  } // namespace

  TEST_P(SlidingBlock, holds_until_friction_and_bond_are_both_exhausted)
  {
    const SceneRun result = run("sliding-block.prm");
    EXPECT_EQ(result.status(), "completed");
    // The first increment behind the limit is up to one step of softening low.
    EXPECT_NEAR(result.number("peak force [N]"),
                friction + bond,
                bond * step / .2 + 1e-4 * (friction + bond));
    EXPECT_NEAR(result.number("force at end [N]"), friction, 1e-4 * friction);
    EXPECT_NEAR(result.number("adhesion dissipation [mJ]"),
                fracture,
                1e-6 * fracture);
    EXPECT_NEAR(result.number("friction dissipation [mJ]"),
                friction,
                friction * step);
  }

  TEST_P(SlidingBlock, rubs_with_mu_N_alone_without_a_bond)
  {
    const SceneRun result = run("sliding-block.prm", {"Adhesion/law=none"});
    EXPECT_EQ(result.status(), "completed");
    EXPECT_NEAR(result.number("peak force [N]"), friction, 1e-4 * friction);
    EXPECT_NEAR(result.number("force at end [N]"), friction, 1e-4 * friction);
    EXPECT_NEAR(result.number("friction dissipation [mJ]"),
                friction,
                friction * step);
    EXPECT_EQ(result.number("adhesion dissipation [mJ]"), 0.);
  }

  TEST(CondensedSlidingBlock, rubs_with_mu_N_too)
  {
    const SceneRun result = run_mortar("sliding-block.prm",
                                       {"Adhesion/law=none",
                                        "Contact/multipliers=dual",
                                        "Contact/condensed=true"});
    EXPECT_EQ(result.status(), "completed");
    EXPECT_NEAR(result.number("force at end [N]"), friction, 1e-4 * friction);
    EXPECT_NEAR(result.number("friction dissipation [mJ]"),
                friction,
                friction * step);
  }

  TEST_P(SlidingBlock, shears_off_the_bond_alone_without_friction)
  {
    const SceneRun result =
      run("sliding-block.prm", {"Friction/coefficient=0"});
    EXPECT_EQ(result.status(), "completed");
    EXPECT_NEAR(result.number("peak force [N]"),
                bond,
                bond * step / .2 + 1e-4 * bond);
    EXPECT_NEAR(result.number("force at end [N]"), 0., 1e-9 * bond);
    EXPECT_NEAR(result.number("adhesion dissipation [mJ]"),
                fracture,
                1e-6 * fracture);
    EXPECT_EQ(result.number("friction dissipation [mJ]"), 0.);
  }

  INSTANTIATE_TEST_SUITE_P(Mortar,
                           SlidingBlock,
                           testing::Values("standard", "dual"));
} // namespace demold

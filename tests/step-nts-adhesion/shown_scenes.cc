// SPDX-License-Identifier: LGPL-2.1-or-later
// press.prm, edge-peel.prm, press-shear-pull.prm: scenes without a closed form
// must balance forces and energies.
#include "step-nts-adhesion/run_nts.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    double sum(const std::vector<double> &values)
    {
      double total = 0.;
      for (const double x : values)
        total += x;
      return total;
    }

    class Press : public testing::TestWithParam<double>
    {};
  } // namespace

  TEST_P(Press, balances_the_force_of_the_grip_at_the_interface)
  {
    const SceneRun run =
      run_nts("press.prm",
              {"Friction/coefficient=" + std::to_string(GetParam())});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.status(), "completed");
    const double force = run.number("force at end [N]");
    EXPECT_GT(force, 10.);
    EXPECT_NEAR(sum(run.interface["force z [N]"]), force, 1e-5 * force);
    EXPECT_NEAR(sum(run.interface["force x [N]"]), 0., 1e-3 * force);
    EXPECT_NEAR(sum(run.interface["force y [N]"]), 0., 1e-3 * force);
    EXPECT_LT(run.number("energy balance error [-]"), .01);
    if (GetParam() > 0.)
      EXPECT_GT(run.number("friction dissipation [mJ]"), 0.);
    else
      EXPECT_EQ(run.number("friction dissipation [mJ]"), 0.);
  }

  INSTANTIATE_TEST_SUITE_P(friction, Press, testing::Values(0., .3));

  TEST(EdgePeel, lets_go_from_the_lifted_edge_to_the_other)
  {
    const SceneRun run = run_nts("edge-peel.prm");
    EXPECT_EQ(run.status(), "completed");
    EXPECT_LT(run.number("energy balance error [-]"), .01);
    EXPECT_LT(run.number("peak force [N]"), .5 * .2 * 200.);
    const auto  &time = run.interface["separation time [s]"];
    const auto  &x    = run.interface["x [mm]"]; // ascending
    unsigned int n    = 0;
    for (std::size_t i = 1; i < x.size(); ++i)
      if (x[i] <= 16. && !std::isnan(time[i - 1]))
        {
          ++n;
          EXPECT_GE(time[i - 1], time[i]) << x[i];
        }
    EXPECT_GT(n, 40u);
  }

  TEST(PressShearPull, holds_in_shear_under_pressure_and_lets_go_with_it)
  {
    const SceneRun run = run_nts("press-shear-pull.prm");
    EXPECT_EQ(run.status(), "completed");
    EXPECT_LT(run.number("energy balance error [-]"), .01);
    EXPECT_EQ(run.number("bonded area left [mm^2]"), 0.);
    EXPECT_GT(run.number("friction dissipation [mJ]"), 0.);
    const double G_c_A = .5 * .2 * .2 * 100.;
    EXPECT_NEAR(run.number("adhesion dissipation [mJ]"), G_c_A, 1e-6 * G_c_A);
    const auto &time = run.interface["separation time [s]"];
    EXPECT_GT(*std::min_element(time.begin(), time.end()), .4);
    EXPECT_LT(*std::max_element(time.begin(), time.end()), .41);
  }
} // namespace demold

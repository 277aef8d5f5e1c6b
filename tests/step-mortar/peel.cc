// SPDX-License-Identifier: LGPL-2.1-or-later
// peel.prm: steady peeling at ninety degree (theory E.3).
#include "step-mortar/run_mortar.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    /// Steady force per width [N/mm] at ninety degree of an incompressible
    /// neo-Hooke strip in plane strain: P h l - h W = G_c.
    double steady_force()
    {
      constexpr double mu = 1., h = 2., G = .02;
      const auto       P = [](double l) { return mu * (l - std::pow(l, -3)); };
      const auto       W = [](double l) {
        return .5 * mu * (l * l + 1. / (l * l) - 2.);
      };
      const double l =
        root_of([&](double s) { return P(s) * h * s - h * W(s) - G; }, 1., 1.5);
      return P(l) * h;
    }
  } // namespace

  TEST(MortarPeel, needs_the_force_of_kendalls_balance)
  {
    EXPECT_NEAR(steady_force(), .019975, 1e-6);
    const SceneRun run = run_mortar("peel.prm");
    EXPECT_EQ(run.status(), "completed");
    EXPECT_LT(run.number("energy balance error [-]"), .005);
    // From 52 mm on the arm is long; the mean by the work in between.
    const auto &u = run.history["opening [mm]"];
    const auto &W = run.history["external work [mJ]"];
    const auto  i = static_cast<std::size_t>(
      std::lower_bound(u.begin(), u.end(), 52.) - u.begin());
    const double mean = (W.back() - W.at(i)) / (u.back() - u.at(i));
    record("mean steady force over closed form", mean / steady_force());
    EXPECT_NEAR(mean, steady_force(), .02 * steady_force());
    EXPECT_GT(run.number("bonded area left [mm^2]"), 5.);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// peel.prm, peel-30.prm: steady peeling, theory E.3.
#include "step-nts-adhesion/run_nts.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    /// Steady force per width [N/mm] of an incompressible neo-Hooke strip in
    /// plane strain: P h (l - cos) - h W = G_c.
    double steady_force(const double angle)
    {
      constexpr double mu = 1., h = 2., G = .02;
      const auto       P = [](double l) { return mu * (l - std::pow(l, -3)); };
      const auto       W = [](double l) {
        return .5 * mu * (l * l + 1. / (l * l) - 2.);
      };
      const double l = root_of(
        [&](double s) {
          return P(s) * h * (s - std::cos(angle)) - h * W(s) - G;
        },
        1.,
        1.5);
      return P(l) * h;
    }

    /// Mean force between two openings, by the work in between.
    double mean_force(const CsvTable &history, const double from)
    {
      const auto &u = history["opening [mm]"];
      const auto &W = history["external work [mJ]"];
      const auto  i = static_cast<std::size_t>(
        std::lower_bound(u.begin(), u.end(), from) - u.begin());
      return (W.back() - W.at(i)) / (u.back() - u.at(i));
    }
  } // namespace

  TEST(Peel, closed_form_has_the_values_of_theory_E3)
  {
    const double degree = std::acos(-1.) / 180.;
    EXPECT_NEAR(steady_force(90. * degree), .019975, 1e-6);
    EXPECT_NEAR(steady_force(30. * degree), .13998, 1e-5);
    EXPECT_NEAR(steady_force(0.), .54606, 1e-5);
  }

  TEST(Peel, needs_the_force_of_kendalls_balance_at_ninety_degree)
  {
    const SceneRun run = run_nts("peel.prm");
    EXPECT_EQ(run.status(), "completed");
    // The bend at the front and that at the grip are 12 mm long. From here on
    // the arm is five times as long; the force still comes down by a percent.
    EXPECT_LT(run.number("energy balance error [-]"), .005);
    const double exact = steady_force(std::acos(0.));
    const double mean  = mean_force(run.history, 52.);
    record("mean steady force over closed form", mean / exact);
    EXPECT_NEAR(mean, exact, .02 * exact);
    // Steady: the force stays, and bonds are left for it to stay.
    for (std::size_t i = 0; i < run.history.n_rows(); ++i)
      if (run.history["opening [mm]"][i] > 52.)
        EXPECT_NEAR(run.history["force [N]"][i], exact, .05 * exact);
    EXPECT_GT(run.number("bonded area left [mm^2]"), 5.);
    EXPECT_GT(run.number("adhesion dissipation [mJ]"), .5);
  }

  TEST(Peel, needs_the_force_of_kendalls_balance_at_thirty_degree)
  {
    const SceneRun run = run_nts("peel-30.prm");
    EXPECT_EQ(run.status(), "completed");
    EXPECT_LT(run.number("energy balance error [-]"), .005);

    // The direction in which bonds and contact are pulled at the end.
    const double degree = std::acos(-1.) / 180.;
    double       x = 0., y = 0.;
    for (std::size_t i = 0; i < run.interface.n_rows(); ++i)
      {
        x += run.interface["force x [N]"][i];
        y += run.interface["force y [N]"][i];
      }
    const double angle = std::atan2(std::abs(y), std::abs(x)) / degree;
    record("angle of the force in degree", angle);
    EXPECT_NEAR(angle, 30., .3);

    // Steady: from 12 s on the front goes on, and the force stays.
    const double exact = steady_force(30. * degree);
    const auto  &t     = run.history["time [s]"];
    const auto  &F     = run.history["force [N]"];
    const auto  &A     = run.history["bonded area [mm^2]"];
    const auto   first = static_cast<std::size_t>(
      std::lower_bound(t.begin(), t.end(), 12.) - t.begin());
    double sum = 0.;
    for (std::size_t i = first + 1; i < t.size(); ++i)
      {
        EXPECT_NEAR(F[i], exact, .03 * exact) << t[i];
        sum += .5 * (F[i] + F[i - 1]) * (t[i] - t[i - 1]);
      }
    const double mean = sum / (t.back() - t.at(first));
    record("mean steady force over closed form", mean / exact);
    EXPECT_NEAR(mean, exact, .02 * exact);
    // At .5 mm/s; the bond lets go node by node, every .25 mm.
    EXPECT_NEAR(A.at(first) - A.back(), .5 * (t.back() - t.at(first)), .6);
    EXPECT_GT(A.back(), 5.);
  }
} // namespace demold

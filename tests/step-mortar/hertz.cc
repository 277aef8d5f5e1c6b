// SPDX-License-Identifier: LGPL-2.1-or-later
// hertz.prm: pressure, width and scatter, beside node to segment on the same
// mesh (theory E.6).
#include "hertz_ellipse.h"
#include "step-mortar/run_mortar.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    /// Standard deviation of the nodal pressures from Hertz' curve over its
    /// peak, but for the last node, which carries for the open one behind it.
    /// Two bodies of the same rubber yield twice as much as one.
    double scatter(const CsvTable &points)
    {
      constexpr double element = .05; // [mm]
      Ellipse          exact   = hertz();
      exact.half_width *= std::sqrt(2.);
      exact.peak /= std::sqrt(2.);
      double       sum = 0.;
      unsigned int n   = 0;
      for (std::size_t i = 0; i < points.n_rows(); ++i)
        {
          const double x = points["x [mm]"][i] / exact.half_width;
          if (std::abs(x) > 1. - 2. * element / exact.half_width)
            continue;
          const double p = std::sqrt(1. - x * x);
          sum += std::pow(points["pressure [MPa]"][i] / exact.peak - p, 2);
          ++n;
        }
      return std::sqrt(sum / n);
    }

    class Hertz : public Multipliers
    {};
  } // namespace

  TEST_P(Hertz, has_width_and_pressure_within_one_and_a_half_percent)
  {
    const SceneRun result = run("hertz.prm");
    EXPECT_EQ(result.status(), "completed");
    const Ellipse exact = hertz(), found = fit(result.interface);
    record("half-width", found.half_width / exact.half_width - 1.);
    record("peak of the ellipse", found.peak / exact.peak - 1.);
    record("largest pressure",
           largest_pressure(result.interface) / exact.peak - 1.);
    EXPECT_NEAR(found.half_width, exact.half_width, .015 * exact.half_width);
    EXPECT_NEAR(found.peak, exact.peak, .015 * exact.peak);
    EXPECT_NEAR(largest_pressure(result.interface),
                exact.peak,
                .015 * exact.peak);
  }

  TEST_P(Hertz, scatters_a_third_as_much_as_node_to_segment_does)
  {
    const char  *scene  = "hertz-two-bodies.prm";
    const double mortar = scatter(run(scene).interface);
    const double nodes  = scatter(run_node_to_segment(scene).interface);
    record("mortar", mortar);
    record("node to segment", nodes);
    EXPECT_LT(mortar, nodes / 3.);
  }

  INSTANTIATE_TEST_SUITE_P(Mortar, Hertz, testing::Values("standard", "dual"));
} // namespace demold

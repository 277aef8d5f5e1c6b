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
    /// peak, where the curve is above a fifth of it: at the end of the contact
    /// a node cannot follow.
    double scatter(const CsvTable &points)
    {
      const Ellipse exact = hertz();
      double        sum   = 0.;
      unsigned int  n     = 0;
      for (std::size_t i = 0; i < points.n_rows(); ++i)
        {
          const double x = points["x [mm]"][i] / exact.half_width;
          if (std::abs(x) > .98)
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
    const double mortar = scatter(run("hertz.prm").interface);
    const double nodes  = scatter(run_node_to_segment("hertz.prm").interface);
    record("mortar", mortar);
    record("node to segment", nodes);
    EXPECT_LT(mortar, nodes / 3.);
  }

  INSTANTIATE_TEST_SUITE_P(Mortar, Hertz, testing::Values("standard", "dual"));
} // namespace demold

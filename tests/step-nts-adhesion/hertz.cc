// SPDX-License-Identifier: LGPL-2.1-or-later
// hertz.prm: a cylinder on a rigid plane (Johnson 1985, chapter 4; theory E.6).
#include "hertz_ellipse.h"
#include "step-nts-adhesion/run_nts.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    /// Largest deviation of half-width and peak at an element size.
    double error(const SceneRun &run)
    {
      const Ellipse exact = hertz(), found = fit(run.interface);
      return std::max(std::abs(found.half_width / exact.half_width - 1.),
                      std::abs(found.peak / exact.peak - 1.));
    }
  } // namespace

  TEST(Hertz, closed_form_has_the_values_of_the_scene)
  {
    EXPECT_NEAR(hertz().half_width, .56790, 2e-5);
    EXPECT_NEAR(hertz().peak, .11210, 1e-5);
  }

  TEST(Hertz, presses_an_ellipse_of_the_right_width_and_height)
  {
    const SceneRun run = run_nts("hertz.prm");
    EXPECT_EQ(run.status(), "completed");
    const Ellipse exact = hertz(), found = fit(run.interface);
    EXPECT_NEAR(found.half_width, exact.half_width, .03 * exact.half_width);
    EXPECT_NEAR(found.peak, exact.peak, .03 * exact.peak);
    EXPECT_NEAR(largest_pressure(run.interface), exact.peak, .08 * exact.peak);

    const auto &force = run.interface["force y [N]"];
    double      sum   = 0.;
    for (const double f : force)
      sum += f;
    EXPECT_NEAR(2. * sum, line_load, 1e-6 * line_load); // half model
  }

  // Straight faces of quadratic elements press harder at their ends than in
  // the middle; less so the shorter they are.
  TEST(Hertz, comes_closer_with_finer_quadratic_elements)
  {
    double last = 1.;
    for (const char *size : {"0.2", "0.1", "0.05"})
      {
        const SceneRun run =
          run_nts("hertz.prm",
                  {"element=q2", std::string("Body/fine size=") + size});
        const double waves =
          largest_pressure(run.interface) / hertz().peak - 1.;
        record(std::string("error with ") + size + " mm", error(run));
        record(std::string("waves with ") + size + " mm", waves);
        EXPECT_LT(waves, .6 * last);
        last = waves;
      }
    EXPECT_LT(last, .05);
  }

  TEST(Hertz, comes_closer_with_finer_elements)
  {
    const double coarse = error(run_nts("hertz.prm", {"Body/fine size=0.2"}));
    const double middle = error(run_nts("hertz.prm", {"Body/fine size=0.1"}));
    const double fine   = error(run_nts("hertz.prm", {"Body/fine size=0.05"}));
    record("error with 0.2 mm", coarse);
    record("error with 0.1 mm", middle);
    record("error with 0.05 mm", fine);
    EXPECT_LT(fine, middle);
    EXPECT_LT(middle, coarse);
  }
} // namespace demold

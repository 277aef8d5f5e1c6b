// SPDX-License-Identifier: LGPL-2.1-or-later
// punch.prm: a flat punch pulled off a half space (Kendall 1971; theory E.5).
#include "step-arclength/circular_front.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double radius = 5.; // [mm]
    constexpr double w      = .5 * .5 * .04;

    /// G = F^2/(8 pi E* a^3) = w.
    double brittle_force(const double a)
    {
      return std::sqrt(8. * pi * reduced_modulus * w * a * a * a);
    }

    double peak(const std::vector<FrontRow> &rows)
    {
      double most = 0.;
      for (const FrontRow &row : rows)
        most = std::max(most, row.F);
      return most;
    }
  } // namespace

  TEST(Punch, closed_form_has_the_value_of_the_scene)
  {
    EXPECT_NEAR(brittle_force(radius), 11.137, 1e-3);
  }

  TEST(Punch, lets_go_along_the_path_of_a_brittle_bond)
  {
    const SceneRun run = run_arclength("punch.prm");
    ASSERT_EQ(run.exit_code, 0);
    const auto rows = front_rows(run, w);
    record("peak over brittle force", peak(rows) / brittle_force(radius));
    EXPECT_NEAR(peak(rows), brittle_force(radius), .05 * brittle_force(radius));
    double       worst = 0.;
    unsigned int n     = 0;
    for (const FrontRow &row : rows)
      if (row.a < .95 * radius && row.a > .4 * radius)
        {
          worst = std::max(worst, std::abs(row.F / brittle_force(row.a) - 1.));
          ++n;
        }
    record("largest deviation", worst);
    EXPECT_LT(worst, .05);
    EXPECT_GE(n, 30u);
    EXPECT_LT(run.number("energy balance error [-]"), 5e-3);
  }

  // Force and opening fall together, so that a grip is of no help.
  TEST(Punch, jumps_off_at_the_peak_without_a_path)
  {
    const SceneRun run  = run_arclength("punch.prm",
                                       {"Solution/strategy=quasi-static",
                                         "Solution/smallest increment=1e-4"});
    const auto     rows = front_rows(run, w);
    EXPECT_NEAR(peak(rows), brittle_force(radius), .05 * brittle_force(radius));
    for (const FrontRow &row : rows)
      if (row.bonded)
        EXPECT_GT(row.a, .9 * radius);
  }
} // namespace demold

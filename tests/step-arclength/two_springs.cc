// SPDX-License-Identifier: LGPL-2.1-or-later
// two-springs.prm: the monitor finds where a branch loses its stability.
#include "step-arclength/path_points.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double strength = .2, penalty = 20., k_s = 5., k_m = 2.;

    /// Slope k_t of a bond [N/mm].
    double slope(const double rupture_gap)
    {
      return -strength / (rupture_gap - strength / penalty);
    }

    /// Eigenvalue [N/mm] nearest to zero where both bonds have the slope k_t:
    /// the antisymmetric mode, and two of the symmetric one.
    double smallest_eigenvalue(const double k_t)
    {
      const double half = .5 * (k_t + 3. * k_s + k_m);
      const double det  = (k_t + k_s) * (2. * k_s + k_m) - 2. * k_s * k_s;
      const double low  = half - std::sqrt(half * half - det);
      return std::abs(low) < std::abs(k_t + k_s) ? low : k_t + k_s;
    }

    /// Negative pivots while both bonds soften, -1 if the rows disagree.
    int pivots_while_softening(const double rupture_gap)
    {
      char text[60];
      std::snprintf(text,
                    sizeof(text),
                    "Adhesion/rupture gap=%.9g",
                    rupture_gap);
      const SceneRun run   = run_arclength("two-springs.prm", {text});
      int            count = -2;
      for (const PathRow &row : path_rows(run))
        if (row.adhesion > 0. && row.bonded == 2.)
          count = count == -2 || count == row.negative_pivots ?
                    row.negative_pivots :
                    -1;
      return count;
    }
  } // namespace

  // Theory E.1b: singular at k_t = -k_s k_m/(2 k_s + k_m), antisymmetrically at
  // -k_s.
  TEST(TwoSprings, have_the_negative_pivots_of_their_branches)
  {
    EXPECT_EQ(pivots_while_softening(.41), 0); // k_t = -.5
    EXPECT_EQ(pivots_while_softening(.21), 1); // k_t = -1
    EXPECT_EQ(pivots_while_softening(.1), 1);  // k_t = -2.2222
    EXPECT_EQ(pivots_while_softening(.04), 2); // k_t = -6.6667
  }

  TEST(TwoSprings, monitor_finds_the_critical_slope)
  {
    double unstable = .2, stable = .3;
    while (slope(stable) - slope(unstable) > 5e-5)
      {
        const double middle = .5 * (unstable + stable);
        (pivots_while_softening(middle) > 0 ? unstable : stable) = middle;
      }
    const double critical = -k_s * k_m / (2. * k_s + k_m);
    EXPECT_NEAR(slope(.5 * (unstable + stable)), critical, 1e-4);
  }

  TEST(TwoSprings, monitor_finds_the_smallest_eigenvalue)
  {
    for (const double rupture_gap : {.41, .21, .1})
      {
        const SceneRun run =
          run_arclength("two-springs.prm",
                        {"Adhesion/rupture gap=" + std::to_string(rupture_gap),
                         "Solution/smallest eigenvalue=true"});
        const double expected = smallest_eigenvalue(slope(rupture_gap));
        unsigned int n        = 0;
        for (const PathRow &row : path_rows(run))
          if (row.adhesion > 0. && row.bonded == 2.)
            {
              EXPECT_NEAR(row.eigenvalue, expected, 1e-4) << rupture_gap;
              ++n;
            }
        EXPECT_GT(n, 2u);
      }
  }

  TEST(TwoSprings, limit_point_is_reported)
  {
    const std::string events =
      run_arclength("two-springs.prm").summary.at("events");
    EXPECT_NE(events.find("1 negative pivots after 0, beyond a limit point"),
              std::string::npos)
      << events;
  }
} // namespace demold

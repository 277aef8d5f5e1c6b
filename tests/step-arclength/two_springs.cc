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
} // namespace demold

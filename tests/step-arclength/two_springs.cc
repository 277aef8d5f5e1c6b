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

  /// Both bonds could soften together, and do where nobody asks. On the other
  /// branch b unloads while a softens, and lets go after it.
  TEST(TwoSprings, leave_the_symmetric_path_along_the_eigenvector)
  {
    const double   rupture_gap = .04, k_t = slope(rupture_gap);
    const SceneRun run =
      run_arclength("two-springs.prm",
                    {"Adhesion/rupture gap=" + std::to_string(rupture_gap),
                     "Solution/branch at bifurcations=true"});
    EXPECT_NE(std::string(run.summary.at("events"))
                .find("onto another branch at a bifurcation"),
              std::string::npos);

    // Opening and force where one bond softens at the traction t, beside the
    // stiffness of the other and its spring.
    const auto state = [&](const double t, const double other) {
      const double bar   = rupture_gap + t / k_t + t / k_s;
      const double force = t + other * bar;
      return std::make_pair(bar + force / k_m, force);
    };
    const auto   rows        = path_rows(run);
    unsigned int one_softens = 0, last_softens = 0;
    double       b_unloads = 0.; // [N/mm] with its spring; 0: not yet
    for (std::size_t i = 1; i < rows.size(); ++i)
      {
        const PathRow &row = rows[i];
        if (b_unloads == 0. && row.negative_pivots == 1)
          { // from the traction both had reached, towards the origin
            const double t = .5 * rows[i - 1].F;
            b_unloads      = 1. / ((rupture_gap + t / k_t) / t + 1. / k_s);
          }
        if (b_unloads == 0. || row.adhesion == rows[i - 1].adhesion)
          continue;
        const bool   both  = rows[i - 1].bonded == 2.; // until this row
        const double other = both ? b_unloads : 0.;
        // Both are linear in t: the point of the same opening.
        const auto   none = state(0., other), full = state(strength, other);
        const double t =
          (row.u - none.first) / (full.first - none.first) * strength;
        EXPECT_NEAR(row.F, state(t, other).second, 1e-3 * 2. * strength)
          << row.u;
        (both ? one_softens : last_softens) += 1;
      }
    EXPECT_GE(one_softens, 3u);
    EXPECT_GE(last_softens, 2u);
  }
} // namespace demold

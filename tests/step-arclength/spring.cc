// SPDX-License-Identifier: LGPL-2.1-or-later
// spring.prm: the path of theory E.1a for three stiffnesses and by every
// constraint, the released energy, and the honest clock.
#include "step-arclength/path_points.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    struct Case
    {
      double      stiffness;
      std::string constraint;
    };

    void PrintTo(const Case &c, std::ostream *out)
    {
      *out << c.stiffness << " N/mm, " << c.constraint;
    }

    SceneRun run_spring(const Case &c)
    {
      return run_arclength("spring.prm",
                           {"Network/springs=bar grip y " +
                              std::to_string(c.stiffness),
                            "Solution/path constraint=" + c.constraint});
    }

    class SpringPath : public testing::TestWithParam<Case>
    {};
  } // namespace

  TEST_P(SpringPath, is_the_closed_form_everywhere)
  {
    const Case          c = GetParam();
    const SpringAndBond form{c.stiffness, {}};
    const SceneRun      run = run_spring(c);
    ASSERT_EQ(run.exit_code, 0);
    EXPECT_LT(run.number("energy balance error [-]"), 1e-3);

    double       worst               = 0.;
    unsigned int on_softening_branch = 0;
    for (const PathRow &row : path_rows(run))
      {
        worst = std::max(worst, form.deviation(row.u, row.F));
        if (row.adhesion > 0. && row.bonded > 0.)
          {
            ++on_softening_branch;
            // slope of the bond -2.2222 against the spring (theory E.1b)
            EXPECT_EQ(row.negative_pivots, c.stiffness < 2.2222 ? 1 : 0);
          }
        else
          EXPECT_EQ(row.negative_pivots, 0);
      }
    record("largest deviation", worst);
    EXPECT_LT(worst, 1e-3);
    EXPECT_GE(on_softening_branch, 8u);
  }

  TEST_P(SpringPath, releases_what_the_bond_does_not_need)
  {
    const Case          c = GetParam();
    const SpringAndBond form{c.stiffness, {}};
    const SceneRun      run = run_spring(c);
    // W_peak - G_c, theory E.1a: 0.031, 0.0043333 and nothing
    const double released = form.released();
    EXPECT_EQ(run.number("jumps"), released > 0. ? 1. : 0.);
    EXPECT_NEAR(run.number("released energy [mJ]"),
                released,
                5e-3 * std::max(released, 1e-6));
    EXPECT_NEAR(run.number("work of demolding [mJ]"),
                released + form.bond.fracture_energy(),
                5e-3 * (released + form.bond.fracture_energy()));
    EXPECT_EQ(run.status(),
              released > 0. ? "completed with jumps" : "completed");
  }

  INSTANTIATE_TEST_SUITE_P(constraints,
                           SpringPath,
                           testing::Values(Case{.5, "dissipation"},
                                           Case{1.5, "dissipation"},
                                           Case{5., "dissipation"},
                                           Case{.5, "largest opening"},
                                           Case{.5, "interface"},
                                           Case{.5, "cylindrical"},
                                           Case{.5, "adaptive"}));

  // The machine's clock stands still while the path is behind it, and shows
  // the opening otherwise, as it pulls with 1 mm/s.
  TEST(SpringClock, shows_the_largest_opening_so_far)
  {
    const SceneRun run     = run_spring({.5, "dissipation"});
    double         largest = 0.;
    unsigned int   behind  = 0;
    for (const PathRow &row : path_rows(run))
      {
        largest = std::max(largest, row.u);
        EXPECT_NEAR(row.clock, largest, 1e-12);
        behind += row.u < largest - 1e-9 ? 1 : 0;
      }
    EXPECT_GE(behind, 8u);
    EXPECT_NEAR(largest, .5, 1e-12);
  }

  // Without a path the same scene jumps, and the ledger misses the same energy.
  TEST(SpringWithoutPath, jumps_where_the_path_turns_back)
  {
    const SpringAndBond form{.5, {}};
    const SceneRun      run = run_arclength("spring.prm",
                                       {"Solution/path constraint=load",
                                             "Solution/largest increment=0.001",
                                             "Solver/max iterations=60"});
    EXPECT_EQ(run.status(), "completed with jumps");
    EXPECT_NEAR(run.number("released energy [mJ]"),
                form.released(),
                .02 * form.released());
  }
} // namespace demold

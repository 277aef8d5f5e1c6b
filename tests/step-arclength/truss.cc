// SPDX-License-Identifier: LGPL-2.1-or-later
// truss.prm, truss-snap-back.prm: von Mises truss against its closed form.
#include "step-arclength/path_points.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double EA = 1., h = 1., b = 10.;
    constexpr double k = 2e-4; // [N/mm] of the spring in series

    double cube_of_length()
    {
      return std::pow(h * h + b * b, 1.5);
    }

    /// Load at the deflection w, Green strain.
    double load(const double w)
    {
      return EA * w * (w - h) * (w - 2. * h) / (2. * cube_of_length());
    }

    double slope(const double w)
    {
      return EA * (3. * w * w - 6. * w * h + 2. * h * h) /
             (2. * cube_of_length());
    }

    double limit_load()
    {
      return EA * h * h * h / (3. * std::sqrt(3.) * cube_of_length());
    }
  } // namespace

  TEST(Truss, has_the_limit_load_of_the_literature)
  {
    EXPECT_NEAR(limit_load(), 1.89599e-4, 1e-9);
    EXPECT_NEAR(load(h * (1. - 1. / std::sqrt(3.))), limit_load(), 1e-15);
  }

  class TrussPath : public testing::TestWithParam<std::string>
  {};

  TEST_P(TrussPath, snaps_through_along_the_closed_form)
  {
    const SceneRun run =
      run_arclength("truss.prm", {"Solution/path constraint=" + GetParam()});
    ASSERT_EQ(run.exit_code, 0);
    unsigned int between_limits = 0;
    for (const PathRow &row : path_rows(run))
      {
        EXPECT_NEAR(row.F, load(row.u), 1e-3 * limit_load());
        const bool unstable = slope(row.u) < 0.;
        between_limits += unstable ? 1 : 0;
        EXPECT_EQ(row.negative_pivots, unstable ? 1 : 0) << row.u;
      }
    EXPECT_GE(between_limits, 10u);
  }

  INSTANTIATE_TEST_SUITE_P(constraints,
                           TrussPath,
                           testing::Values("cylindrical", "adaptive"));

  // A machine that lets the load grow jumps from the limit to the same load on
  // the other side; the load does more than the truss stores meanwhile.
  TEST(Truss, releases_energy_as_it_snaps_through)
  {
    const SceneRun run = run_arclength("truss.prm",
                                       {"Solution/first increment=0.01",
                                        "Solution/largest increment=0.05"});
    const double   w1  = h * (1. - 1. / std::sqrt(3.));
    const double   w2 =
      root_of([](double w) { return load(w) - limit_load(); }, 2. * h, 4. * h);
    const double released =
      limit_load() * (w2 - w1) - integral_of(load, w1, w2);
    EXPECT_EQ(run.number("jumps"), 1.);
    EXPECT_NEAR(run.number("released energy [mJ]"), released, 5e-3 * released);
    EXPECT_LT(run.number("energy balance error [-]"), 1e-2);
  }

  TEST(TrussWithSpring, snaps_back_along_the_closed_form)
  {
    ASSERT_LT(k, EA * h * h / (2. * cube_of_length()));
    const SceneRun run = run_arclength("truss-snap-back.prm");
    ASSERT_EQ(run.exit_code, 0);
    unsigned int on_the_way_back = 0;
    double       last            = 0.;
    for (const PathRow &row : path_rows(run))
      {
        const double w = row.u - row.F / k;
        EXPECT_NEAR(row.F, load(w), 1e-3 * limit_load());
        EXPECT_EQ(row.negative_pivots, slope(w) + k < 0. ? 1 : 0) << w;
        on_the_way_back += row.u < last ? 1 : 0;
        last = row.u;
      }
    EXPECT_GE(on_the_way_back, 5u);
  }
} // namespace demold

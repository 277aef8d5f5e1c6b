// SPDX-License-Identifier: LGPL-2.1-or-later
// slice-explicit.prm: the slice by explicit dynamics with scaled masses is that
// of implicit dynamics, and says so where masses are scaled too much.
#include "step-demold/demolding.h"

#include <gtest/gtest.h>

namespace demold
{
  TEST(ExplicitSlice, is_demolded_as_by_implicit_dynamics)
  {
    const SceneRun run = run_demold("slice-explicit.prm");
    expect_clean_release(run);
    expect_energy_of_the_bond(run, 2);
    EXPECT_EQ(run.number("factorisations"), 0.);
    EXPECT_EQ(run.number("newton iterations"), 0.);

    const SceneRun implicitly = run_demold("slice.prm");
    const double   peak       = implicitly.number("peak force [N]");
    const double   work       = implicitly.number("work of demolding [mJ]");
    EXPECT_NEAR(run.number("peak force [N]"), peak, .01 * peak);
    EXPECT_NEAR(run.number("work of demolding [mJ]"), work, .02 * work);
    EXPECT_LT(run.number("kinetic share up to the peak [-]"), .05);
    const std::string events = run.summary.at("events");
    EXPECT_EQ(events.find("WARNING"), std::string::npos) << events;
  }

  TEST(ExplicitSlice, warns_where_scaled_masses_take_part_in_the_peak)
  {
    const SceneRun run =
      run_demold("slice-explicit.prm", {"Solution/mass scaling=1000"});
    expect_clean_release(run);
    EXPECT_GT(run.number("kinetic share up to the peak [-]"), .05);
    const std::string events = run.summary.at("events");
    for (const char *words : {"WARNING", "kinetic energy", "mass scaling"})
      EXPECT_NE(events.find(words), std::string::npos) << events;
  }
} // namespace demold

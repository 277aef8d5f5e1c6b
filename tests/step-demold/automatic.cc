// SPDX-License-Identifier: LGPL-2.1-or-later
// slice.prm with a bond so steep that it lets go in jumps.
#include "step-demold/demolding.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    SceneRun steep_slice(const std::string &strategy)
    {
      return run_demold("slice.prm",
                        {"Adhesion/rupture gap=0.02",
                         "Solution/accuracy=0.1",
                         "Solution/strategy=" + strategy});
    }
  } // namespace

  TEST(SteepSlice, is_demolded_by_automatic_as_by_dynamics)
  {
    const SceneRun automatic = steep_slice("automatic");
    expect_clean_release(automatic);
    const double lost = .1 * G_c * bonded_line(2) * 20.; // a tenth of the gap
    EXPECT_NEAR(automatic.number("adhesion dissipation [mJ]"),
                lost,
                .005 * lost);
    const SceneRun dynamics = steep_slice("dynamics");
    const double   peak     = dynamics.number("peak force [N]");
    EXPECT_NEAR(automatic.number("peak force [N]"), peak, .02 * peak);
    EXPECT_LT(automatic.number("newton iterations"),
              1.3 * dynamics.number("newton iterations"));
    EXPECT_GT(automatic.number("share of increments with inertia [-]"), .1);
    EXPECT_LT(automatic.number("share of increments with inertia [-]"), 1.);
    const std::string events = automatic.summary.at("events");
    EXPECT_NE(events.find("dynamics, because"), std::string::npos) << events;
    EXPECT_NE(events.find("quasi-static, because"), std::string::npos)
      << events;
  }
} // namespace demold

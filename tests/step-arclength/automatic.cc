// SPDX-License-Identifier: LGPL-2.1-or-later
// `automatic` where nodes let go one by one in jumps too small to matter.
#include "step-arclength/path_points.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    const std::string density = "Material/density=1.1e-9";

    unsigned int count(const std::string &events, const std::string &what)
    {
      unsigned int n = 0;
      for (auto i = events.find(what); i != std::string::npos;
           i      = events.find(what, i + 1))
        ++n;
      return n;
    }

    void expect_paths_and_no_inertia(const SceneRun &run)
    {
      EXPECT_EQ(run.exit_code, 0);
      const std::string events = run.summary.at("events");
      record("detours", count(events, "arc length, "));
      EXPECT_GE(count(events, "arc length, "), 3u) << events;
      EXPECT_EQ(count(events, "dynamics, "), 0u) << events;
      EXPECT_EQ(run.number("share of increments with inertia [-]"), 0.);
      EXPECT_LT(run.number("energy balance error [-]"), 2e-3);
    }
  } // namespace

  TEST(Automatic, opens_the_double_cantilever_without_inertia)
  {
    const SceneRun automatic =
      run_arclength("double-cantilever.prm",
                    {density, "Solution/strategy=automatic"});
    expect_paths_and_no_inertia(automatic);
    const SceneRun path = run_arclength("double-cantilever.prm");
    const double   peak = path.number("peak force [N]");
    EXPECT_NEAR(automatic.number("peak force [N]"), peak, .01 * peak);
    const double work = path.number("work of demolding [mJ]");
    EXPECT_NEAR(automatic.number("work of demolding [mJ]"), work, .01 * work);
  }

  /// Until past -1.5 pi w R, at an opening of 0.437 in the units of Maugis,
  /// where a load jumps and a grip does not.
  TEST(Automatic, passes_the_limit_of_a_load_without_inertia)
  {
    const SceneRun run = run_arclength("jkr-grip.prm",
                                       {density,
                                        "Adhesion/viscous time=0",
                                        "Solution/strategy=automatic",
                                        "Solution/accuracy=1",
                                        "Process/end time=1.74"});
    expect_paths_and_no_inertia(run);
    const double limit = 1.5 * M_PI * 4e-4 * 10.; // theory E.7 [N]
    EXPECT_NEAR(run.number("peak force [N]"), limit, .05 * limit);
    const double K    = 4. / 3. * 3. / (1. - .49 * .49);
    const double unit = std::cbrt(std::pow(M_PI * 4e-4, 2) * 10. / (K * K));
    EXPECT_GT(run.number("opening at end [mm]"), 1.1 * .43679 * unit);
    EXPECT_GT(run.number("bonded area left [mm^2]"), 0.);
  }
} // namespace demold

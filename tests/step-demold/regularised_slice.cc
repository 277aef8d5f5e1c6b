// SPDX-License-Identifier: LGPL-2.1-or-later
// slice-steep.prm by quasi-statics: not without viscous damage, but with it.
#include "step-demold/demolding.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    SceneRun steep_slice(const std::string &viscous_time)
    {
      return run_demold("slice-steep.prm",
                        {"Solution/strategy=quasi-static",
                         "Adhesion/viscous time=" + viscous_time});
    }
  } // namespace

  TEST(RegularisedSlice, is_demolded_by_quasi_statics)
  {
    // a tenth of the gap of slice.prm
    const double lost  = .1 * G_c * bonded_line(2) * 20.;
    double       taken = 1e300, peak = 1e300;
    for (const std::string viscous_time : {"1e-3", "1e-4"})
      {
        const SceneRun run = steep_slice(viscous_time);
        expect_clean_release(run);
        EXPECT_EQ(run.status(), "completed");
        EXPECT_EQ(run.number("jumps"), 0.);
        EXPECT_NEAR(run.number("adhesion dissipation [mJ]"), lost, .005 * lost);
        // The shorter the time, the less is taken and the lower the peak.
        EXPECT_LT(run.number("regularisation dissipation [mJ]"), .5 * taken);
        EXPECT_LT(run.number("peak force [N]"), peak);
        taken = run.number("regularisation dissipation [mJ]");
        peak  = run.number("peak force [N]");
      }
  }

  TEST(RegularisedSlice, is_not_without)
  {
    const SceneRun run = steep_slice("0");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.status(), "gave up");
  }
} // namespace demold

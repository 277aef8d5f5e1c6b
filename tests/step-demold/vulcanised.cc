// SPDX-License-Identifier: LGPL-2.1-or-later
// The slice with the cure its press gives it.
#include "step-demold/demolding.h"

namespace demold
{
  TEST(Vulcanised, slice_releases_cleanly_and_loses_the_energy_of_its_bond)
  {
    const SceneRun run = run_demold("slice-vulcanised.prm");
    expect_clean_release(run);
    expect_energy_of_the_bond(run, 2);

    // Within the tables, and not of one value.
    EXPECT_EQ(run.number("points of clamped f90"), 0.);
    EXPECT_GT(run.number("largest f90 [-]"),
              1.2 * run.number("smallest f90 [-]"));
    // Stiffer rubber raises the peak (theory F): it lies between those of the
    // extremes.
    const auto peak_of = [&](const std::string &which) {
      return run_demold("slice.prm",
                        {"Material/f90=" + std::to_string(run.number(which))})
        .number("peak force [N]");
    };
    EXPECT_GT(run.number("peak force [N]"), peak_of("smallest f90 [-]"));
    EXPECT_LT(run.number("peak force [N]"), peak_of("largest f90 [-]"));
  }

  TEST(Vulcanised, by_one_temperature_throughout_is_uniform)
  {
    // 160 degC, where t90 = 409 s, for 0.7 t90.
    const SceneRun vulcanised =
      run_demold("slice-vulcanised.prm",
                 {"Press/initial temperature=160",
                  "Press/Mould side/temperature=160",
                  "Press/Bladder side/temperature=160",
                  "Press/opening time=286.3"});
    const SceneRun uniform = run_demold("slice.prm", {"Material/f90=0.7"});
    for (const std::string which : {"smallest", "mean", "largest"})
      EXPECT_NEAR(vulcanised.number(which + " f90 [-]"), .7, 1e-6);
    for (const std::string key : {"peak force [N]", "work of demolding [mJ]"})
      EXPECT_NEAR(vulcanised.number(key),
                  uniform.number(key),
                  1e-4 * uniform.number(key));
  }
} // namespace demold

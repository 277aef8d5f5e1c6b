// SPDX-License-Identifier: LGPL-2.1-or-later
// The slice with the cure its press gives it.
#include "run_scene.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    SceneRun run_slice(const std::string              &scene,
                       const std::vector<std::string> &overrides = {})
    {
      return run_scene(DEMOLD_STEP_DEMOLD,
                       DEMOLD_SOURCE_DIR "/prm/step-demold/" + scene,
                       overrides);
    }
  } // namespace

  TEST(Vulcanised, slice_releases_cleanly_and_loses_the_energy_of_its_bond)
  {
    const SceneRun run = run_slice("slice-vulcanised.prm");
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.status(), "completed");
    EXPECT_LE(run.number("energy balance error [-]"), .01);
    EXPECT_EQ(run.number("bonded area left [mm^2]"), 0.);
    // alpha delta/2 = 0.01 mJ/mm^2 times the line of the slice, 20 mm wide,
    // 8 mm high, draft 3 degree, two sipes of 0.6 mm by 6 mm, draft 0.5 degree
    const double degree = M_PI / 180.;
    const double line   = 20. - 2. * .6 + 2. * 8. / std::cos(3. * degree) +
                        2. * (2. * 6. / std::cos(.5 * degree) + .6 -
                              2. * 6. * std::tan(.5 * degree));
    const double energy = .01 * line * 20.;
    EXPECT_NEAR(run.number("adhesion dissipation [mJ]"), energy, .005 * energy);

    // Within the tables, and not of one value.
    EXPECT_EQ(run.number("points of clamped f90"), 0.);
    EXPECT_GT(run.number("largest f90 [-]"),
              1.2 * run.number("smallest f90 [-]"));
    // Stiffer rubber raises the peak (theory F): it lies between those of the
    // extremes.
    const auto peak_of = [&](const std::string &which) {
      return run_slice("slice.prm",
                       {"Material/f90=" + std::to_string(run.number(which))})
        .number("peak force [N]");
    };
    EXPECT_GT(run.number("peak force [N]"), peak_of("smallest f90 [-]"));
    EXPECT_LT(run.number("peak force [N]"), peak_of("largest f90 [-]"));
  }

  TEST(Vulcanised, by_one_temperature_throughout_is_uniform)
  {
    // 160 degC, where t90 = 409 s, for 0.7 t90.
    const SceneRun vulcanised = run_slice("slice-vulcanised.prm",
                                          {"Press/initial temperature=160",
                                           "Press/Mould side/temperature=160",
                                           "Press/Bladder side/temperature=160",
                                           "Press/opening time=286.3"});
    const SceneRun uniform    = run_slice("slice.prm", {"Material/f90=0.7"});
    for (const std::string which : {"smallest", "mean", "largest"})
      EXPECT_NEAR(vulcanised.number(which + " f90 [-]"), .7, 1e-6);
    for (const std::string key : {"peak force [N]", "work of demolding [mJ]"})
      EXPECT_NEAR(vulcanised.number(key),
                  uniform.number(key),
                  1e-4 * uniform.number(key));
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// A study of a real scene agrees with the runs it is made of.
#include "run_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demold
{
  TEST(StudyOfPullOff, has_the_errors_of_its_runs_against_the_fracture_energy)
  {
    const ScratchFolder folder;
    const int           code =
      run_command({DEMOLD_STUDY,
                   DEMOLD_SOURCE_DIR "/prm/studies/pull-off-increments.prm",
                   "--quiet",
                   "--output",
                   folder / "out",
                   "--set",
                   "Sweep 1/from=0.01",
                   "--set",
                   "Sweep 1/to=0.0025",
                   "--set",
                   "Sweep 1/number=2"},
                  folder / "log");
    ASSERT_EQ(code, 0) << folder.read("log");
    const CsvTable table = read_csv(folder.read("out/study.csv"));
    ASSERT_EQ(table.n_rows(), 2u);
    const std::string scene =
      DEMOLD_SOURCE_DIR "/prm/step-nts-adhesion/pull-off.prm";
    std::vector<double> errors;
    for (const char *const increment : {"0.01", "0.0025"})
      {
        const SceneRun run =
          run_scene(DEMOLD_STEP_NTS_ADHESION,
                    scene,
                    {std::string("Solution/largest increment=") + increment});
        const double lost = .5 * .2 * .1 * 2.; // G_c A [mJ]
        errors.push_back(
          std::abs(run.number("work of demolding [mJ]") / lost - 1.));
      }
    EXPECT_NEAR(table["error [-]"][0], errors[0], 1e-9);
    EXPECT_NEAR(table["error [-]"][1], errors[1], 1e-9);
    EXPECT_NEAR(table["observed order [-]"][1],
                std::log(errors[0] / errors[1]) / std::log(4.),
                1e-6);
  }
} // namespace demold

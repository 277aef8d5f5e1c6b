// SPDX-License-Identifier: LGPL-2.1-or-later
// What a fit writes is a piece of a scene as it stands.
#include "task_run.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demold
{
  namespace
  {
    /// A scene of step-material that includes @p file: rubber pulled slowly
    /// to @p stretch in @p mode.
    std::string pulled(const ScratchFolder &folder,
                       const std::string   &file,
                       const std::string   &mode,
                       const double         stretch)
    {
      std::ostringstream text;
      text << "set task = protocol\ninclude " << file
           << "\nsubsection Protocol\n  set mode = " << mode
           << "\n  set programme = ramp\n  set strain = " << stretch - 1.
           << "\n  set rate = 0.1\n  set time step = 1\nend\n";
      return folder.write("scene.prm", text.str());
    }

    void expect_checked(const std::string &program, const std::string &scene)
    {
      const ScratchFolder folder;
      EXPECT_EQ(run_command({program, scene, "--check"}, folder / "log"), 0)
        << folder.read("log");
      EXPECT_TRUE(contains(folder.read("log"), "What will be simulated"));
    }

    double last_stress(const TaskRun &run)
    {
      return run.table("history.csv")["nominal stress [MPa]"].back();
    }
  } // namespace



  TEST(static_fit, a_scene_answers_what_the_fit_has_promised)
  {
    const TaskRun  fit(shipped("treloar-fit.prm"),
                      {"Static fit/law=mooney-rivlin",
                        "Static fit/equibiaxial file=" +
                          shipped("data/treloar-equibiaxial.csv")});
    const CsvTable promised = fit.table("fit.csv");
    const auto    &x        = promised["stretch or shear [-]"];
    unsigned int   n        = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (x[i] == 1.24 || x[i] == 1.42)
        {
          const ScratchFolder folder;
          const TaskRun       run(pulled(folder,
                                   fit.file("material.prm"),
                                   x[i] == 1.24 ? "uniaxial" : "equibiaxial",
                                   x[i]));
          // The tables have six digits or more.
          EXPECT_NEAR(last_stress(run) / promised["model [MPa]"][i], 1., 1e-5);
          ++n;
        }
    EXPECT_EQ(n, 2u);
  }

  TEST(static_fit, incompressible_moduli_hold_in_a_scene_of_large_lambda)
  {
    const TaskRun       fit(shipped("treloar-fit.prm"));
    const ScratchFolder folder;
    const TaskRun run(pulled(folder, fit.file("material.prm"), "uniaxial", 1.5),
                      {"Material/lambda=1e7"});
    const double  mu1 = fit.number("mu1 [MPa]"), mu2 = fit.number("mu2 [MPa]");
    EXPECT_NEAR(last_stress(run),
                (mu1 + mu2 / 1.5) * (1.5 - 1. / (1.5 * 1.5)),
                1e-6);
  }

  TEST(static_fit, an_ogden_fit_takes_away_the_include_of_an_earlier_one)
  {
    const ScratchFolder folder;
    for (const char *const law : {"mooney-rivlin", "ogden"})
      {
        ASSERT_EQ(run_command({DEMOLD_STEP_MATERIAL,
                               shipped("treloar-fit.prm"),
                               "--quiet",
                               "--output",
                               folder / "out",
                               "--set",
                               std::string("Static fit/law=") + law},
                              folder / "log"),
                  0)
          << folder.read("log");
        EXPECT_EQ(std::filesystem::exists(folder / "out/material.prm"),
                  std::string(law) == "mooney-rivlin");
      }
  }

  // The slow limit of a series is its equilibrium modulus.
  TEST(relaxation_fit, its_rubber_relaxes_to_the_equilibrium_modulus)
  {
    const TaskRun       fit(shipped("relaxation-fit.prm"));
    const ScratchFolder folder;
    const TaskRun       run(
      pulled(folder, fit.file("material.prm"), "simple shear", 2.),
      {"Protocol/strain=0.01", "Protocol/rate=1e-9", "Protocol/time step=1e6"});
    const double E = fit.table("series.csv")["modulus [MPa]"].back();
    EXPECT_NEAR(last_stress(run), .01 * E / 3., 1e-6);
  }

  TEST(dma_fit, its_table_over_f90_is_one_of_all_steps)
  {
    const TaskRun       fit(shipped("dma-fit.prm"));
    const ScratchFolder folder;
    const TaskRun run(pulled(folder, fit.file("material.prm"), "uniaxial", 1.5),
                      {"Protocol/f90 levels=0.6, 0.8, 1.0"});
    EXPECT_EQ(run.words("status"), "completed");
    const std::string include = "include " + fit.file("material.prm") + "\n";
    expect_checked(DEMOLD_STEP_NTS_ADHESION,
                   folder.write("nts.prm",
                                "include " DEMOLD_SOURCE_DIR
                                "/prm/step-nts-adhesion/adhesion-patch.prm\n" +
                                  include));
    expect_checked(DEMOLD_STEP_DEMOLD,
                   folder.write("slice.prm",
                                "include " DEMOLD_SOURCE_DIR
                                "/prm/step-demold/slice.prm\n" +
                                  include));
  }

  // f90 = 1 and a degree of cure of 0.9 where t90 was spent at T_ref.
  TEST(cure_fit, its_kinetics_cure_a_block_in_t90)
  {
    const TaskRun       fit(shipped("cure-fit.prm"));
    const ScratchFolder folder;
    std::ostringstream  t90;
    t90.precision(12);
    t90 << fit.number("t90 at 160 degC [s]");
    const TaskRun run(
      folder.write("cycle.prm",
                   "set task = cure cycle\ninclude " + fit.file("cure.prm") +
                     "\nsubsection Press\n  set initial temperature = 160\n"
                     "  set opening time = 10\n  set end time = " +
                     t90.str() +
                     "\n  subsection Mould side\n    set contact = perfect\n"
                     "    set temperature = 0: 160\n  end\n"
                     "  subsection Bladder side\n    set contact = perfect\n"
                     "    set temperature = 0: 160\n  end\nend\n"),
      {"Press/air temperature=160"});
    EXPECT_NEAR(run.number("f90 in the middle [-]"), 1., 1e-6);
    EXPECT_NEAR(run.number("degree of cure in the middle [-]"), .9, .03);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// The shipped scenes of the material rig keep their claims.
#include "run_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  namespace
  {
    /// What a run of step-material has left behind.
    struct TaskRun
    {
      nlohmann::json summary;
      CsvTable       history, cases;

      double number(const std::string &key) const
      {
        return summary.at(key).get<double>();
      }
    };

    TaskRun run_protocol(const std::string              &scene,
                         const std::vector<std::string> &overrides = {})
    {
      const ScratchFolder      folder;
      std::vector<std::string> command = {DEMOLD_STEP_MATERIAL,
                                          std::string(DEMOLD_SOURCE_DIR) +
                                            "/prm/step-material/" + scene,
                                          "--quiet",
                                          "--output",
                                          folder / "out"};
      for (const auto &entry : overrides)
        {
          command.emplace_back("--set");
          command.push_back(entry);
        }
      if (run_command(command, folder / "log") != 0)
        throw std::runtime_error(scene + ": " + folder.read("log"));
      return {nlohmann::json::parse(folder.read("out/summary.json")),
              read_csv(folder.read("out/history.csv")),
              read_csv(folder.read("out/cases.csv"))};
    }

    /// The value of @p column at @p time.
    double at(const CsvTable    &table,
              const std::string &column,
              const double       time)
    {
      const auto &times = table["time [s]"];
      for (std::size_t i = times.size(); i-- > 0;)
        if (std::abs(times[i] - time) < 1e-9)
          return table[column][i];
      throw std::runtime_error("no row at that time");
    }
  } // namespace



  TEST(relaxation, in_shear_is_that_of_E9_within_1e_6)
  {
    const TaskRun run        = run_protocol("relaxation.prm");
    const double  table[][2] = {{.5, .51221132},
                                {1., .30170331},
                                {2., .11288969}};
    for (const auto &[time, branch] : table)
      EXPECT_NEAR(at(run.history, "nominal stress [MPa]", time),
                  .5 + .5 * branch,
                  1e-6);
    EXPECT_LT(run.number("largest relative error [-]"), 1e-6);
    EXPECT_LT(run.number("energy balance error [-]"), 1e-5);
  }

  TEST(relaxation, in_extension_is_that_of_E9_within_1e_6)
  {
    const TaskRun run =
      run_protocol("relaxation.prm",
                   {"Protocol/mode=uniaxial", "Material/lambda=1e7"});
    // Cauchy stress of the branch over its modulus, and of Mooney-Rivlin.
    const double table[][2] = {{.5, 1.27788739},
                               {1., .64082930},
                               {2., .20468581}};
    const double elastic    = (.4 + .1 / 2.) * (2. - 1. / 4.) * 2.;
    for (const auto &[time, branch] : table)
      EXPECT_NEAR(at(run.history, "cauchy stress [MPa]", time),
                  elastic + .5 * branch,
                  1e-6);
  }

  TEST(relaxation, converges_with_the_order_of_its_update)
  {
    const std::pair<const char *, double> updates[] = {{"BE", 1.},
                                                       {"EXP2", 2.}};
    for (const auto &[update, order] : updates)
      {
        double errors[2];
        for (unsigned int i = 0; i < 2; ++i)
          errors[i] = run_protocol("relaxation.prm",
                                   {std::string("Material/update=") + update,
                                    i == 0 ? "Protocol/time step=0.02" :
                                             "Protocol/time step=0.01"})
                        .number("relative error [-]");
        EXPECT_NEAR(std::log2(errors[0] / errors[1]), order, .1) << update;
      }
  }

  TEST(wiechert, the_closed_form_is_found_within_1e_4)
  {
    const TaskRun run = run_protocol("wiechert.prm");
    EXPECT_LT(run.number("relative error [-]"), 1e-4);
    EXPECT_EQ(run.cases.n_rows(), 39u);

    // The largest tan psi of f90 = 0.6, and of 0.8 and 1.0.
    const auto &f90  = run.cases["f90 [-]"];
    const auto &tan  = run.cases["tan psi [-]"];
    double      soft = 0., hard = 0.;
    for (std::size_t i = 0; i < f90.size(); ++i)
      (f90[i] < .7 ? soft : hard) = std::max(f90[i] < .7 ? soft : hard, tan[i]);
    EXPECT_GT(soft, hard);
  }

  TEST(cyclic_shear, stiffness_and_hysteresis_rise_with_rate)
  {
    const TaskRun run  = run_protocol("cyclic-shear.prm");
    const auto   &loop = run.cases["hysteresis of last cycle [mJ/mm^3]"];
    const auto   &peak = run.cases["peak stress [MPa]"];
    ASSERT_EQ(loop.size(), 5u);
    for (std::size_t i = 1; i < loop.size(); ++i)
      {
        EXPECT_GT(std::abs(peak[i]), std::abs(peak[i - 1]));
        EXPECT_GT(loop[i], loop[i - 1]);
      }
    EXPECT_LT(run.number("energy balance error [-]"), 1e-4);
  }

  TEST(uniaxial_at_cure_levels, more_cure_is_stiffer_at_every_stretch)
  {
    const TaskRun run    = run_protocol("uniaxial-at-cure-levels.prm");
    const auto   &number = run.history["case [-]"];
    const auto   &stress = run.history["nominal stress [MPa]"];
    const auto    n_rows = std::count(number.begin(), number.end(), 1.);
    ASSERT_EQ(run.history.n_rows(), 6u * n_rows);
    for (std::size_t i = n_rows; i < stress.size(); ++i)
      if (i % n_rows != 0) // the first row of each is at rest
        {
          EXPECT_EQ(number[i], number[i - n_rows] + 1.);
          EXPECT_GT(stress[i], stress[i - n_rows]) << i;
        }
    EXPECT_LT(run.number("largest relative error [-]"), 1e-6);
  }
} // namespace demold

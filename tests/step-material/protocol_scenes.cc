// SPDX-License-Identifier: LGPL-2.1-or-later
// The shipped scenes of the material rig keep their claims.
#include "task_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  namespace
  {
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
    const TaskRun  run(shipped("relaxation.prm"));
    const CsvTable history    = run.table("history.csv");
    const double   table[][2] = {{.5, .51221132},
                                 {1., .30170331},
                                 {2., .11288969}};
    for (const auto &[time, branch] : table)
      EXPECT_NEAR(at(history, "nominal stress [MPa]", time),
                  .5 + .5 * branch,
                  1e-6);
    EXPECT_LT(run.number("largest relative error [-]"), 1e-6);
    EXPECT_LT(run.number("energy balance error [-]"), 1e-5);
  }

  TEST(relaxation, in_extension_is_that_of_E9_within_1e_6)
  {
    const TaskRun  run(shipped("relaxation.prm"),
                      {"Protocol/mode=uniaxial", "Material/lambda=1e7"});
    const CsvTable history = run.table("history.csv");
    // Cauchy stress of the branch over its modulus, and of Mooney-Rivlin.
    const double table[][2] = {{.5, 1.27788739},
                               {1., .64082930},
                               {2., .20468581}};
    const double elastic    = (.4 + .1 / 2.) * (2. - 1. / 4.) * 2.;
    for (const auto &[time, branch] : table)
      EXPECT_NEAR(at(history, "cauchy stress [MPa]", time),
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
          errors[i] = TaskRun(shipped("relaxation.prm"),
                              {std::string("Material/update=") + update,
                               i == 0 ? "Protocol/time step=0.02" :
                                        "Protocol/time step=0.01"})
                        .number("relative error [-]");
        EXPECT_NEAR(std::log2(errors[0] / errors[1]), order, .1) << update;
      }
  }

  TEST(wiechert, the_closed_form_is_found_within_1e_4)
  {
    const TaskRun  run(shipped("wiechert.prm"));
    const CsvTable cases = run.table("cases.csv");
    EXPECT_LT(run.number("relative error [-]"), 1e-4);
    EXPECT_EQ(cases.n_rows(), 39u);

    // The largest tan psi of f90 = 0.6, and of 0.8 and 1.0.
    const auto &f90  = cases["f90 [-]"];
    const auto &tan  = cases["tan psi [-]"];
    double      soft = 0., hard = 0.;
    for (std::size_t i = 0; i < f90.size(); ++i)
      (f90[i] < .7 ? soft : hard) = std::max(f90[i] < .7 ? soft : hard, tan[i]);
    EXPECT_GT(soft, hard);
  }

  TEST(cyclic_shear, stiffness_and_hysteresis_rise_with_rate)
  {
    const TaskRun  run(shipped("cyclic-shear.prm"));
    const CsvTable cases = run.table("cases.csv");
    const auto    &loop  = cases["hysteresis of last cycle [mJ/mm^3]"];
    const auto    &peak  = cases["peak stress [MPa]"];
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
    const TaskRun  run(shipped("uniaxial-at-cure-levels.prm"));
    const CsvTable history = run.table("history.csv");
    const auto    &number  = history["case [-]"];
    const auto    &stress  = history["nominal stress [MPa]"];
    const auto     n_rows  = std::count(number.begin(), number.end(), 1.);
    ASSERT_EQ(history.n_rows(), 6u * n_rows);
    for (std::size_t i = n_rows; i < stress.size(); ++i)
      if (i % n_rows != 0) // the first row of each is at rest
        {
          EXPECT_EQ(number[i], number[i - n_rows] + 1.);
          EXPECT_GT(stress[i], stress[i - n_rows]) << i;
        }
    EXPECT_LT(run.number("largest relative error [-]"), 1e-6);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// The task `protocol` from its entries to its files.
#include "base/parameter_entries.h"
#include "base/parameter_error.h"
#include "rig/protocol_output.h"
#include "rig/protocol_parameters.h"
#include "run_scene.h"
#include "scratch_folder.h"

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    using Entries = std::vector<std::pair<std::string, std::string>>;

    /// Checked by the caller.
    void set(ProtocolParameters &parameters, Entries entries)
    {
      dealii::ParameterHandler prm;
      parameters.add_parameters(prm);
      entries.insert(entries.begin(),
                     {{"Material/relaxation times", "1"},
                      {"Material/branch moduli", "1.5"}});
      set_entries(prm, entries);
    }

    std::string complaint(const Entries &entries)
    {
      return message_of<ExcParameter>([&]() {
        ProtocolParameters parameters;
        set(parameters, entries);
        parameters.check();
      });
    }

    std::vector<ProtocolRun> run_all(const ProtocolParameters &parameters)
    {
      std::vector<ProtocolRun> runs;
      for (const auto &test : parameters.cases())
        runs.push_back(run_protocol(parameters, test));
      return runs;
    }

    double quantity(const ProtocolRun &run, const std::string &name)
    {
      for (const auto &[key, value] : run.quantities)
        if (key == name)
          return value;
      throw std::runtime_error("no " + name);
    }
  } // namespace



  TEST(BadProtocols, are_named_with_path_rule_and_number)
  {
    const std::pair<Entries, std::string> bad[] = {
      {{{"Protocol/strain", "0"}}, "Protocol/strain: must not be 0"},
      {{{"Protocol/strain", "-1.5"}}, "would be -0.5"},
      {{{"Protocol/programme", "cycles"},
        {"Protocol/strain", "0.8"},
        {"Protocol/mean strain", "-0.5"}},
       "Protocol/mean strain: must leave a stretch greater than 0; the "
       "smallest would be -0.3"},
      {{{"Protocol/rate", "0"}}, "Protocol/rate: must be greater than 0"},
      {{{"Protocol/rate", "-1"}}, "Protocol/rate"},
      {{{"Protocol/programme", "relaxation"}, {"Protocol/rate", "0"}},
       "Protocol/hold time: must be greater than 0"},
      {{{"Protocol/programme", "creep"}}, "Protocol/hold time: must be"},
      {{{"Protocol/programme", "creep"},
        {"Protocol/hold time", "1"},
        {"Protocol/stress", "0"}},
       "Protocol/stress: must not be 0"},
      {{{"Protocol/programme", "frequency sweep"}, {"Protocol/steps", "7"}},
       "Protocol/steps: must be at least 8"},
      {{{"Protocol/time step", "1e-9"}},
       "Protocol/time step: must give at most 2e+06 steps in all; got 5e+08"},
      {{{"Protocol/time step", "0"}}, "Protocol/time step"},
      {{{"Protocol/frequencies", ""}}, "Protocol/frequencies"},
      {{{"Protocol/frequencies", "1, 0"}}, "Protocol/frequencies"},
      {{{"Protocol/temperatures", "20, 70"}},
       "Protocol/temperatures: needs Material/time-temperature shift"},
      {{{"Protocol/temperatures", "-70"},
        {"Material/time-temperature shift", "WLF"}},
       "Material/temperature: must exceed"},
      {{{"Protocol/mode", "torsion"}}, "Protocol/mode"},
      {{{"Material/f90", "0.5 + x"}}, "Material/f90"}};
    for (const auto &[entries, words] : bad)
      EXPECT_TRUE(contains(complaint(entries), words))
        << words << " <-> " << complaint(entries);
    EXPECT_EQ(complaint({}), "");
  }

  TEST(BadProtocols, a_level_outside_the_table_is_named)
  {
    const Entries table = {{"Material/branch moduli", ""},
                           {"Material/table f90", "0.5, 0.7, 1.0, 1.2"},
                           {"Material/table equilibrium modulus", "1, 2, 3, 4"},
                           {"Material/table branch moduli", "1; 1; 1; 1"},
                           {"Protocol/f90 levels", "0.5, 1.3"}};
    EXPECT_TRUE(contains(complaint(table), "0.5 to 1.2; got 1.3"))
      << complaint(table);
  }



  TEST(Protocols, run_every_f90_temperature_and_frequency)
  {
    ProtocolParameters parameters;
    set(parameters,
        {{"Material/branch moduli", ""},
         {"Material/table f90", "0.5, 0.7, 1.0, 1.2"},
         {"Material/table equilibrium modulus", "1, 2, 3, 4"},
         {"Material/table branch moduli", "1; 1; 1; 1"},
         {"Material/time-temperature shift", "WLF"},
         {"Protocol/f90 levels", "0.7, 1.2"},
         {"Protocol/temperatures", "70, 90, 150"},
         {"Protocol/programme", "cycles"},
         {"Protocol/frequencies", "1, 10"}});
    parameters.check();
    const auto cases = parameters.cases();
    ASSERT_EQ(cases.size(), 12u);
    EXPECT_EQ(cases[0].swept, 1.);
    EXPECT_EQ(cases[1].swept, 10.);
    EXPECT_EQ(cases[2].temperature, 90.);
    EXPECT_EQ(cases[6].f90, 1.2);
    EXPECT_NEAR(cases[6].law.shear_modulus_relaxed(), 4. / 3., 1e-14);
    // WLF with the default constants, theory A.2
    EXPECT_NEAR(cases[2].law.branches[0].relaxation_time,
                std::pow(10., -4.41 * 20. / (137.64 + 20.)),
                1e-14);
  }

  TEST(Protocols, report_stress_reference_and_errors)
  {
    ProtocolParameters parameters;
    set(parameters,
        {{"Protocol/mode", "simple shear"},
         {"Protocol/programme", "relaxation"},
         {"Protocol/strain", "1"},
         {"Protocol/rate", "0"},
         {"Protocol/hold time", "1"},
         {"Protocol/time step", "0.1"},
         {"Protocol/reference", "ida"}});
    parameters.check();
    const ProtocolRun run = run_all(parameters).front();
    // default mu1 + mu2 = 0.5 MPa; theory E.9: mu 0.30170331 after tau
    const double exact     = .5 + .5 * .30170331;
    const double stress    = quantity(run, "stress at end [MPa]");
    const double reference = quantity(run, "reference stress at end [MPa]");
    EXPECT_NEAR(reference, exact, 1e-8);
    EXPECT_NEAR(stress, exact, 1e-4);
    EXPECT_NEAR(quantity(run, "relative error [-]"),
                std::abs(stress - reference) / reference,
                1e-14);
    EXPECT_NEAR(quantity(run, "peak stress [MPa]"), 1., 1e-13);
    EXPECT_GT(quantity(run, "cpu time [s]"), 0.);
    EXPECT_EQ(quantity(run, "steps"), 10.);
  }

  TEST(Protocols, write_a_row_per_step_and_a_row_per_run)
  {
    ProtocolParameters parameters;
    set(parameters,
        {{"Protocol/programme", "rate sweep"},
         {"Protocol/rates", "0.1, 1, 10"},
         {"Protocol/steps", "20"}});
    parameters.check();
    const auto          runs = run_all(parameters);
    const ScratchFolder folder;
    write_curves(folder / "history.csv", parameters, runs);
    write_cases(folder / "cases.csv", parameters, runs);
    const CsvTable history = read_csv(folder.read("history.csv"));
    const CsvTable cases   = read_csv(folder.read("cases.csv"));
    EXPECT_EQ(history.n_rows(), 3u * 21u);
    ASSERT_EQ(cases.n_rows(), 3u);
    const auto &stress = cases["stress at end [MPa]"];
    EXPECT_LT(stress[0], stress[1]);
    EXPECT_LT(stress[1], stress[2]);
    EXPECT_EQ(history["nominal stress [MPa]"].back(), stress[2]);
    EXPECT_EQ(history["rate [1/s]"].front(), .1);
  }

  TEST(Protocols, sum_up_the_largest_error_and_all_steps)
  {
    ProtocolParameters parameters;
    set(parameters,
        {{"Protocol/programme", "frequency sweep"},
         {"Protocol/strain", "1e-4"},
         {"Protocol/frequencies", "0.1, 1"},
         {"Protocol/steps", "50"}});
    parameters.check();
    const auto   runs    = run_all(parameters);
    const double largest = std::max(quantity(runs[0], "relative error [-]"),
                                    quantity(runs[1], "relative error [-]"));
    EXPECT_NE(quantity(runs[0], "relative error [-]"),
              quantity(runs[1], "relative error [-]"));
    const Summary summary = protocol_summary(runs);
    double        error   = 0.;
    long long     steps   = 0;
    for (const auto &[key, value] : summary.entries())
      {
        if (key == "relative error [-]")
          error = std::get<double>(value);
        else if (key == "steps")
          steps = std::get<long long>(value);
      }
    EXPECT_EQ(error, largest);
    EXPECT_EQ(steps, 2 * 3 * 50);
  }
} // namespace demold

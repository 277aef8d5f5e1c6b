// SPDX-License-Identifier: LGPL-2.1-or-later
// A press cycle as its user meets it: entries, refusals, files.
#include "cure/cure_cycle_task.h"

#include "base/parameter_error.h"
#include "scratch_folder.h"

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace demold;

namespace
{
  /// Entries are "Section/.../name=value", separated by ";".
  CureCycleTask parsed(const std::string &entries)
  {
    dealii::ParameterHandler prm;
    CureCycleTask            task;
    task.add_parameters(prm);
    std::istringstream in(entries);
    for (std::string entry; std::getline(in, entry, ';');)
      {
        const auto               equals = entry.find('=');
        std::istringstream       path(entry.substr(0, equals));
        std::string              text, closing;
        std::vector<std::string> names;
        for (std::string name; std::getline(path, name, '/');)
          names.push_back(name);
        for (std::size_t i = 0; i + 1 < names.size(); ++i)
          {
            text += "subsection " + names[i] + "\n";
            closing += "end\n";
          }
        prm.parse_input_from_string(text + "set " + names.back() + " = " +
                                    entry.substr(equals + 1) + "\n" + closing);
      }
    return task;
  }

  std::string complaint(const std::string &entries)
  {
    return message_of<ExcParameter>([&]() { parsed(entries).check(); });
  }

  void expect_words(const std::string              &message,
                    const std::vector<std::string> &words)
  {
    for (const std::string &word : words)
      EXPECT_TRUE(contains(message, word))
        << '"' << word << "\" in \"" << message << '"';
  }

  /// summary.json of a run with @p entries.
  nlohmann::json summary_of(const std::string           &entries,
                            const std::filesystem::path &folder)
  {
    const CureCycleTask task = parsed(entries);
    task.check();
    RunContext context;
    context.output_folder = folder;
    context.quiet         = true;
    EXPECT_EQ(task.run(context), RunStatus::completed);
    return nlohmann::json::parse(std::ifstream(folder / "summary.json"));
  }

  unsigned int n_lines(const std::filesystem::path &file)
  {
    std::ifstream in(file);
    unsigned int  n = 0;
    for (std::string line; std::getline(in, line);)
      ++n;
    return n;
  }

  const std::string isothermal =
    "Press/initial temperature=160;Press/Mould side/temperature=160;"
    "Press/Bladder side/temperature=160;Press/air temperature=160";
} // namespace

TEST(cure_cycle, of_a_block_at_constant_temperature_has_f90_of_time_over_t90)
{
  const ScratchFolder scratch;
  const auto          summary =
    summary_of(isothermal + ";Press/opening time=204.5;Press/end time=409",
               scratch.path);
  EXPECT_EQ(summary["status"], "completed");
  for (const char *const where :
       {"at the mould side", "in the middle", "at the back"})
    {
      const std::string place = where;
      EXPECT_NEAR(summary["f90 " + place + " [-]"], 1., 1e-7);
      EXPECT_NEAR(summary["degree of cure " + place + " [-]"], .9, 1e-6);
      EXPECT_NEAR(summary["f90 " + place + " at the opening [-]"], .5, 1e-7);
      EXPECT_NEAR(summary["degree of cure " + place + " at the opening [-]"],
                  .05,
                  1e-6);
    }
  EXPECT_NEAR(summary["lowest f90 [-]"], 1., 1e-7);
}

TEST(cure_cycle, writes_a_row_for_every_time_and_every_node)
{
  const ScratchFolder scratch;
  summary_of("Press/opening time=100;Press/end time=203;"
             "Cure cycle/output interval=20;Cure cycle/elements=10;"
             "Cure cycle/depths=0, 3.3, 8",
             scratch.path);
  // 0, 20 ... 200 and 203; the opening is one of them
  EXPECT_EQ(n_lines(scratch.path / "history.csv"), 1u + 12u);
  EXPECT_EQ(n_lines(scratch.path / "profile.csv"), 1u + 11u);
  EXPECT_TRUE(std::filesystem::exists(scratch.path / "cure-over-depth.gp"));
}

TEST(cure_cycle, cures_on_while_the_block_cools_in_air)
{
  const ScratchFolder scratch;
  const auto          summary = summary_of("", scratch.path);
  const double        opening = summary["f90 in the middle at the opening [-]"],
               end            = summary["f90 in the middle [-]"];
  EXPECT_GT(end, 1.05 * opening);
  EXPECT_LT(summary["temperature in the middle [degC]"],
            summary["temperature in the middle at the opening [degC]"]);
  EXPECT_LE(summary["lowest f90 [-]"], end);
}

TEST(cure_cycle, takes_every_kinetics_to_about_nine_tenths_at_t90)
{
  for (const char *const law : {"kamal-sourour", "isayev-deng", "han"})
    {
      const ScratchFolder scratch;
      const auto          summary =
        summary_of(std::string("Cure/kinetics=") + law, scratch.path);
      EXPECT_NEAR(
        summary["degree of cure at t90 and reference temperature [-]"],
        .9,
        .02);
    }
}

TEST(cure_cycle, of_han_reverts_where_it_is_hot_for_long)
{
  const ScratchFolder scratch;
  const auto          summary =
    summary_of(isothermal + ";Cure/kinetics=han;Press/opening time=1000;"
                            "Press/end time=3000",
               scratch.path);
  EXPECT_LT(summary["degree of cure in the middle [-]"],
            summary["degree of cure in the middle at the opening [-]"]);
}

TEST(cure_cycle, refuses_entries_that_do_not_fit_each_other)
{
  EXPECT_EQ(complaint(""), "");
  expect_words(complaint("Press/end time=100"),
               {"Press/end time", "opening time = 480", "got 100"});
  expect_words(complaint("Cure cycle/depths=0, 9"),
               {"Cure cycle/depths", "thickness = 8", "got 9"});
  expect_words(complaint("Press/Mould side/contact=insulated;"
                         "Press/Bladder side/contact=insulated"),
               {"Press/Mould side/contact", "insulated"});
  expect_words(complaint("Cure cycle/output interval=1e-4"),
               {"Cure cycle/output interval", "1e6 rows"});
  expect_words(complaint("Cure/conversion degree=0, 1"),
               {"Cure/conversion f90", "13 points"});
  expect_words(complaint(
                 "Cure/conversion f90=0,1,2,3;Cure/conversion degree=0,.5,1,2"),
               {"Cure/conversion degree", "exceed 1"});
}

TEST(temperature, is_a_number_a_table_or_a_formula)
{
  const auto at = [](const std::string &text, const double t) {
    return TemperatureHistory::parse(text, "Press/x")(t);
  };
  EXPECT_EQ(at("165", 7.), 165.);
  EXPECT_DOUBLE_EQ(at("0: 30, 60: 150", 30.), 90.);
  EXPECT_DOUBLE_EQ(at("10: 30, 60: 150", 0.), 30.);
  EXPECT_DOUBLE_EQ(at("10: 30, 60: 150", 100.), 150.);
  EXPECT_DOUBLE_EQ(at("min(30 + 2*t, 165)", 50.), 130.);
  EXPECT_DOUBLE_EQ(at("t < 10 ? 100 : 160", 20.), 160.);
}

TEST(temperature, is_refused_with_the_path_of_its_entry)
{
  const auto message = [](const std::string &text) {
    return complaint("Press/Mould side/temperature=" + text);
  };
  expect_words(message("hot"), {"Press/Mould side/temperature", "\"hot\""});
  expect_words(message("-300"), {"above -273.15", "-300"});
  expect_words(message("0: 30, 0: 50"), {"increase strictly", "0.0"});
  expect_words(message("0: 30, 60"), {"Press/Mould side/temperature", "60"});
  expect_words(message("log(-1-t)"), {"above -273.15", "nan"});
}

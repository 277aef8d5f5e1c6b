// SPDX-License-Identifier: LGPL-2.1-or-later
// The study program from end to end, with a step whose results are known.
#include "run_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  namespace
  {
    /// A folder with a scene, a study of it and the results.
    struct StudyFolder
    {
      explicit StudyFolder(const std::string &more)
      {
        setenv("FAKE_STEP_LOG", (folder / "performed").c_str(), 1);
        folder.write("scene.prm", "# a scene\n");
        folder.write(
          "study.prm",
          "set scene file = scene.prm\nset program file = " DEMOLD_SOURCE_DIR
          "/tests/study/fake-step\n"
          "subsection Sweep 1\n  set entry = Mesh/h\n"
          "  set values = 0.4, 0.2, 0.1\nend\n"
          "subsection Compare\n  set quantity = value [N]\n"
          "  set reference = value\n  set value = 2\nend\n" +
            more);
      }

      int run(const std::vector<std::string> &options = {})
      {
        std::vector<std::string> command = {DEMOLD_STUDY,
                                            folder / "study.prm",
                                            "--output",
                                            folder / "out"};
        command.insert(command.end(), options.begin(), options.end());
        const int code = run_command(command, folder / "log");
        console        = folder.read("log");
        csv            = folder.read("out/study.csv");
        report         = folder.read("out/study.md");
        return code;
      }

      /// How many runs the step has performed in all.
      long n_performed() const
      {
        const std::string log = folder.read("performed");
        return std::count(log.begin(), log.end(), '\n');
      }

      ScratchFolder folder;
      std::string   console, csv, report;
    };

    std::vector<std::string> set(const std::vector<std::string> &entries)
    {
      std::vector<std::string> words;
      for (const auto &entry : entries)
        {
          words.emplace_back("--set");
          words.push_back(entry);
        }
      return words;
    }
  } // namespace

  TEST(StudyProgram, tabulates_errors_orders_and_times)
  {
    StudyFolder study("subsection Sweep 2\n  set entry = order\n"
                      "  set values = 1, 2\nend\n");
    ASSERT_EQ(study.run({"--quiet"}), 0) << study.console;
    EXPECT_EQ(study.console, "");
    const CsvTable table = read_csv(study.csv);
    ASSERT_EQ(table.n_rows(), 6u);
    for (std::size_t i = 0; i < 6; ++i)
      {
        const double h = table["h"][i], p = table["order"][i];
        EXPECT_NEAR(table["error [-]"][i], std::pow(h, p), 1e-12);
        EXPECT_NEAR(table["cpu time [s]"][i], 1. / h, 1e-12);
        EXPECT_EQ(table["unknowns"][i], 7.);
        if (h == .4)
          EXPECT_TRUE(std::isnan(table["observed order [-]"][i]));
        else
          EXPECT_NEAR(table["observed order [-]"][i], p, 1e-9);
      }
    EXPECT_TRUE(contains(study.report, "Order in h, order = 2: 2.00"));
    EXPECT_TRUE(contains(study.report, "Pareto front"));
    const std::string script = study.folder.read("out/error-over-cpu-time.gp");
    EXPECT_TRUE(contains(script, "order = 1: order 1.00")) << script;
    EXPECT_TRUE(contains(script, "'Pareto front'")) << script;
  }

  TEST(StudyProgram, does_not_repeat_runs_with_the_same_settings)
  {
    StudyFolder study("");
    ASSERT_EQ(study.run(), 0) << study.console;
    EXPECT_EQ(study.n_performed(), 3);
    const std::string first = study.csv;
    ASSERT_EQ(study.run(), 0) << study.console;
    EXPECT_EQ(study.n_performed(), 3);
    EXPECT_EQ(study.csv, first);

    // A value more: one run more.
    ASSERT_EQ(study.run(set({"Sweep 1/values=0.4, 0.3, 0.2, 0.1"})), 0);
    EXPECT_EQ(study.n_performed(), 4);
    // Another setting behind the same names of runs: all anew.
    ASSERT_EQ(study.run(set({"settings=order=2"})), 0);
    EXPECT_EQ(study.n_performed(), 7);
    EXPECT_NEAR(read_csv(study.csv)["error [-]"][0], .16, 1e-12);
  }

  TEST(StudyProgram, a_run_without_summary_is_repeated)
  {
    StudyFolder study("");
    ASSERT_EQ(study.run(), 0) << study.console;
    std::filesystem::remove(study.folder / "out/runs/h-0.2/summary.json");
    ASSERT_EQ(study.run(), 0) << study.console;
    EXPECT_EQ(study.n_performed(), 4);
  }

  TEST(StudyProgram, failed_runs_are_rows_with_their_reason)
  {
    StudyFolder study(
      "subsection Sweep 2\n  set entry = outcome\n  set values = "
      "fine, gives-up, killed, silent, not-a-number\nend\n");
    ASSERT_EQ(study.run(set({"Sweep 1/values=0.4, wrong"})), 0)
      << study.console;
    EXPECT_EQ(read_csv(study.csv).n_rows(), 10u);
    for (const char *const row : {"0.4,fine,completed,2.8,2,",
                                  "0.4,gives-up,gave up,,2,",
                                  "0.4,killed,killed,,2,",
                                  "0.4,silent,failed,,2,",
                                  "0.4,not-a-number,completed,,2,",
                                  "wrong,fine,bad input,,2,"})
      EXPECT_TRUE(contains(study.csv, row)) << row << " not in\n" << study.csv;
    for (const char *const reason : {"no equilibrium at 0.3 mm",
                                     "signal 9 (Killed)",
                                     "without summary.json",
                                     "no number for value [N]",
                                     "must be a number, got"})
      EXPECT_TRUE(contains(study.csv, reason)) << reason;
  }

  TEST(StudyProgram, takes_columns_of_tables)
  {
    const std::string column = "Compare/quantity=force [N]";
    // Force is 0, h, 0.5 at openings 0, 1, 3.
    for (const auto &[take, factor, constant] : {std::tuple("largest", 0., .5),
                                                 std::tuple("smallest", 0., 0.),
                                                 std::tuple("end", 0., .5),
                                                 std::tuple("at", .5, 0.)})
      {
        StudyFolder study("");
        ASSERT_EQ(study.run(set({column,
                                 std::string("Compare/take=") + take,
                                 "Compare/at value=h/0.2*0.1"})),
                  0)
          << study.console;
        const CsvTable table = read_csv(study.csv);
        for (std::size_t i = 0; i < 3; ++i)
          {
            // At opening h/2 < 1 the force is h * h/2.
            const double h = table["h"][i];
            EXPECT_NEAR(table["force [N]"][i], factor * h * h + constant, 1e-12)
              << take;
          }
      }
  }

  TEST(StudyProgram, runs_several_at_a_time_with_the_same_result)
  {
    StudyFolder one(""), three("");
    ASSERT_EQ(one.run(), 0);
    ASSERT_EQ(three.run(set({"runs at a time=3"})), 0);
    EXPECT_EQ(one.csv, three.csv);
  }

  TEST(StudyProgram, check_lists_the_runs_and_performs_none)
  {
    StudyFolder study("");
    ASSERT_EQ(study.run({"--check"}), 0) << study.console;
    EXPECT_TRUE(contains(study.console, "2. h = 0.2")) << study.console;
    EXPECT_EQ(study.n_performed(), 0);
    EXPECT_FALSE(std::filesystem::exists(study.folder / "out"));
  }

  TEST(StudyProgram, without_reference_draws_the_quantity)
  {
    StudyFolder study("");
    ASSERT_EQ(study.run(
                set({"Compare/reference=none", "Compare/also list=other [-]"})),
              0)
      << study.console;
    EXPECT_TRUE(contains(study.csv, "h,status,value [N],other [-],cpu"))
      << study.csv;
    EXPECT_TRUE(contains(study.csv, "0.4,completed,2.8,word,")) << study.csv;
    EXPECT_FALSE(contains(study.csv, "error")) << study.csv;
    EXPECT_TRUE(contains(study.folder.read("out/quantity.gp"), "0.1 2.2"));
  }

  TEST(StudyProgram, refuses_what_it_cannot_run_and_writes_nothing)
  {
    const std::vector<std::vector<std::string>> cases = {
      // entry=value, then words of the message
      {"scene file=nowhere.prm", "scene file", "nowhere.prm"},
      {"program file=nowhere", "program file", "nowhere", "./demold build"},
      {"Sweep 1/entry=Mesh/hh", "Sweep 1/entry", "\"Mesh/hh\"", "\"Mesh/h\""},
      {"settings=ordre=2", "settings", "\"ordre\"", "\"order\""},
      {"Sweep 1/values=wrong, bad", "Sweep 1", "every run", "\"wrong\""},
      {"Compare/reference=oracle", "Compare/reference", "oracle"},
      {"Sweep 1/entyr=h", "Sweep 1/entry", "Nearest"}};
    for (const auto &words : cases)
      {
        StudyFolder study("");
        EXPECT_EQ(study.run(set({words[0]})), 2) << study.console;
        EXPECT_EQ(study.console.rfind("Bad input: ", 0), 0u) << study.console;
        for (std::size_t k = 1; k < words.size(); ++k)
          EXPECT_TRUE(contains(study.console, words[k]))
            << words[k] << " not in " << study.console;
        EXPECT_FALSE(std::filesystem::exists(study.folder / "out"));
        EXPECT_EQ(study.n_performed(), 0);
      }
  }

  TEST(StudyProgram, a_misspelt_quantity_ends_it_after_the_first_run)
  {
    StudyFolder study("");
    EXPECT_EQ(study.run(set({"Compare/quantity=vlaue [N]"})), 2);
    EXPECT_TRUE(contains(study.console, "\"value [N]\"")) << study.console;
    EXPECT_EQ(study.n_performed(), 1);
  }
} // namespace demold

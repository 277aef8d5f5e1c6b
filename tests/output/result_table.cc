// SPDX-License-Identifier: LGPL-2.1-or-later
// The history is complete, exact and goes on after a restart.
#include "output/result_table.h"

#include "base/parameter_error.h"
#include "scratch_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demold
{
  namespace
  {
    const std::vector<std::string> columns = {"time [s]",
                                              "force [N]",
                                              "strategy"};

    TEST(ResultTable, every_row_is_on_disk_at_once)
    {
      ScratchFolder folder;
      ResultTable   table(folder / "h.csv", columns);
      EXPECT_EQ(folder.read("h.csv"), "time [s],force [N],strategy\n");
      table.add_row({0.5, -2., "quasi-static"});
      EXPECT_EQ(folder.read("h.csv"),
                "time [s],force [N],strategy\n0.5,-2,quasi-static\n");
      EXPECT_EQ(table.n_rows(), 1u);
    }

    TEST(ResultTable, numbers_keep_fifteen_digits)
    {
      ScratchFolder folder;
      const double  value = std::acos(-1.) * 1e-7;
      ResultTable   table(folder / "h.csv", {"x"});
      table.add_row({value});
      const std::string text = folder.read("h.csv").substr(2);
      EXPECT_NEAR(std::stod(text) / value, 1., 1e-14);
      EXPECT_GT(std::abs(std::stod(text.substr(0, 12)) / value - 1.), 1e-14);
    }

    TEST(ResultTable, a_comma_or_a_quote_in_a_text_does_not_make_a_column)
    {
      ScratchFolder folder;
      ResultTable   table(folder / "h.csv", {"x"});
      table.add_row({"a, \"b\""});
      EXPECT_EQ(folder.read("h.csv"), "x\n\"a, \"\"b\"\"\"\n");
    }

    TEST(ResultTable, a_row_of_the_wrong_length_is_refused)
    {
      ScratchFolder folder;
      ResultTable   table(folder / "h.csv", columns);
      EXPECT_ANY_THROW(table.add_row({1., 2.}));
      EXPECT_EQ(table.n_rows(), 0u);
    }

    TEST(ResultTable, without_a_file_name_nothing_is_written)
    {
      ResultTable table("", columns);
      table.add_row({1., 2., "x"});
      EXPECT_EQ(table.n_rows(), 1u);
    }

    TEST(ResultTable, a_restart_writes_what_an_uninterrupted_run_writes)
    {
      ScratchFolder folder;
      const auto    row = [](const int i) {
        return std::vector<ResultTable::Value>{i / 3., std::sqrt(i), "s"};
      };
      {
        ResultTable whole(folder / "whole.csv", columns);
        ResultTable cut(folder / "cut.csv", columns);
        for (int i = 0; i < 6; ++i)
          whole.add_row(row(i));
        for (int i = 0; i < 4; ++i)
          cut.add_row(row(i));
      }
      // the checkpoint is from after row 3; row 4 is computed again
      for (const char *const target : {"cut.csv", "elsewhere.csv"})
        {
          ResultTable table(folder / target, columns, folder / "cut.csv", 3);
          EXPECT_EQ(table.n_rows(), 3u);
          for (int i = 3; i < 6; ++i)
            table.add_row(row(i));
          EXPECT_EQ(folder.read(target), folder.read("whole.csv"));
        }
    }

    TEST(ResultTable, a_line_cut_off_by_a_crash_does_not_count)
    {
      ScratchFolder folder;
      const auto    file = folder.write("h.csv", "x\n1\n2.5");
      EXPECT_THROW(ResultTable(file, {"x"}, file, 2), ExcParameter);
      EXPECT_EQ(folder.read("h.csv"), "x\n1\n2.5"); // untouched
      ResultTable(file, {"x"}, file, 1);
      EXPECT_EQ(folder.read("h.csv"), "x\n1\n");
    }

    TEST(ResultTable, a_history_of_other_columns_is_refused)
    {
      ScratchFolder folder;
      const auto    file = folder.write("h.csv", "x\n1\n");
      EXPECT_THROW(ResultTable(file, {"y"}, file, 1), ExcParameter);
      EXPECT_THROW(ResultTable(file, {"x"}, folder / "no.csv", 0),
                   ExcParameter);
    }

    TEST(ResultTable, a_full_disk_is_reported)
    {
      if (!std::filesystem::exists("/dev/full"))
        GTEST_SKIP() << "no /dev/full here";
      const auto message = message_of<std::runtime_error>(
        []() { ResultTable table("/dev/full", columns); });
      EXPECT_TRUE(contains(message, "disk full")) << message;
    }
  } // namespace
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// A bad data file is reported once, with file and line.
#include "base/data_file.h"

#include "scratch_folder.h"

#include <gtest/gtest.h>

namespace
{
  using namespace demold;

  const std::vector<DataColumn> columns{{"time [s]", DataColumn::increasing},
                                        {"modulus [MPa]",
                                         DataColumn::positive}};

  /// The message for a file of these lines, from "bad.csv" on.
  std::string complaint(const std::string &text)
  {
    const ScratchFolder folder;
    const std::string   file = folder.write("bad.csv", text);
    const std::string   message =
      message_of<ExcDataFile>([&] { read_data_file(file, columns); });
    const auto name = message.find("bad.csv");
    return name == std::string::npos ? message : message.substr(name);
  }

  TEST(data_file, keeps_source_lines_and_finds_columns_in_any_order)
  {
    const ScratchFolder folder;
    const auto          data =
      read_data_file(folder.write("good.csv",
                                  "# measured\n#by hand\n"
                                  "\"modulus [MPa]\",note,time [s]\r\n"
                                  "2.5,first,0\n\n3e-1,second,1.5\n"),
                     columns);
    EXPECT_EQ(data.source, (std::vector<std::string>{"measured", "by hand"}));
    EXPECT_EQ(data.columns[0], (std::vector<double>{0., 1.5}));
    EXPECT_EQ(data.columns[1], (std::vector<double>{2.5, .3}));
    EXPECT_EQ(data.lines, (std::vector<unsigned int>{4, 6}));
  }

  TEST(data_file, a_missing_column_is_named_with_those_there_are)
  {
    const std::string message = complaint("# x\ntime [s],stress\n1,2\n2,3\n");
    EXPECT_TRUE(contains(message, "bad.csv:2: ")) << message;
    EXPECT_TRUE(contains(message, "\"modulus [MPa]\"")) << message;
    EXPECT_TRUE(contains(message, "\"stress\"")) << message;
  }

  TEST(data_file, a_bad_number_is_reported_with_its_line_and_rule)
  {
    const std::string head = "time [s],modulus [MPa]\n1,2\n";
    struct
    {
      std::string row, rule;
    } const cases[] = {{"2,abc", "must be a number"},
                       {"2,3 MPa", "must be a number"},
                       {"2,", "must be a number"},
                       {"2,nan", "must be a finite number"},
                       {"2,inf", "must be a finite number"},
                       {"2,-3", "must be positive"},
                       {"1,3", "must increase"},
                       {"0.5,3", "exceed 1"},
                       {"-1,3", "must not be negative"},
                       {"2,3,4", "this one has 3"},
                       {"2", "this one has 1"}};
    for (const auto &c : cases)
      {
        const std::string message = complaint(head + c.row + "\n3,4\n");
        EXPECT_TRUE(contains(message, "bad.csv:3: ")) << message;
        EXPECT_TRUE(contains(message, c.rule)) << message;
      }
  }

  TEST(data_file, empty_files_single_points_and_missing_files_are_rejected)
  {
    EXPECT_TRUE(contains(complaint(""), "bad.csv:1: the file holds no data"));
    EXPECT_TRUE(
      contains(complaint("# only\n# words\n"), "bad.csv:2: the file holds no"));
    EXPECT_TRUE(contains(complaint("time [s],modulus [MPa]\n1,2\n"),
                         "bad.csv:2: needs at least 2 rows of numbers; got 1"));
    EXPECT_TRUE(contains(message_of<ExcDataFile>(
                           [] { read_data_file("nowhere.csv", columns); }),
                         "nowhere.csv:1: cannot read"));
  }
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameter files are read with includes, and each mistake names its line.
#include "base/parameter_file.h"

#include "base/parameter_error.h"
#include "scratch_folder.h"

#include <gtest/gtest.h>

#include <tuple>

namespace demold
{
  namespace
  {
    /// "path=value" of the entries, in order.
    std::vector<std::string> entries_of(const std::string &file)
    {
      std::vector<std::string> result;
      for (const auto &s : read_parameter_file(file))
        if (s.kind == ParameterStatement::entry)
          result.push_back(joined_path(s.path) + "=" + s.value);
      return result;
    }

    std::string complaint_about(const std::string &file)
    {
      return message_of<ExcParameter>([&]() { read_parameter_file(file); });
    }

    using List = std::vector<std::string>;

    TEST(ParameterFile, entries_carry_sections_values_and_lines)
    {
      ScratchFolder folder;
      const auto    file  = folder.write("a.prm",
                                     "# a comment\n"
                                         "set dimension = 2 # [-]\n"
                                         "subsection Adhesion\n"
                                         "  subsection  a  b\n"
                                         "    set rupture   gap=  0.5, 1 \r\n"
                                         "  end\n"
                                         "end\n"
                                         "set empty =\n");
      const auto    lines = read_parameter_file(file);
      EXPECT_EQ(
        entries_of(file),
        (List{"dimension=2", "Adhesion/a b/rupture gap=0.5, 1", "empty="}));
      EXPECT_EQ(lines.at(0).origin, file + ":2");
      EXPECT_EQ(lines.at(1).kind, ParameterStatement::section);
      EXPECT_EQ(lines.at(3).origin, file + ":5");
    }

    TEST(ParameterFile, a_backslash_joins_lines)
    {
      ScratchFolder folder;
      const auto    file = folder.write("a.prm",
                                     "set series = 1, \\\n"
                                        "             2\n"
                                        "set b = 3");
      EXPECT_EQ(entries_of(file), (List{"series=1, 2", "b=3"}));
      EXPECT_EQ(read_parameter_file(file).at(1).origin, file + ":3");
    }

    TEST(ParameterFile, included_files_are_sought_beside_the_including_one)
    {
      ScratchFolder folder;
      folder.write("sub/base case.prm", "set a = 1\nset b = 1\n");
      folder.write("sub/deeper/x.prm", "include ../base case.prm\nset b = 2\n");
      const auto file = folder.write("main.prm",
                                     "include \"sub/deeper/x.prm\"\n"
                                     "set a = 3\n");
      EXPECT_EQ(entries_of(file), (List{"a=1", "b=1", "b=2", "a=3"}));
    }

    TEST(ParameterFile, included_files_are_sought_in_the_working_directory_next)
    {
      ScratchFolder folder;
      folder.write("here/base.prm", "set a = 1\n");
      const auto file   = folder.write("there/main.prm", "include base.prm\n");
      const auto before = std::filesystem::current_path();
      std::filesystem::current_path(folder / "here");
      const auto found = entries_of(file);
      std::filesystem::current_path(before);
      EXPECT_EQ(found, (List{"a=1"}));
    }

    TEST(ParameterFile, an_include_inside_a_section_stays_in_it)
    {
      ScratchFolder folder;
      folder.write("law.prm", "set strength = 1\n");
      const auto file = folder.write("main.prm",
                                     "subsection Adhesion\n"
                                     "  include law.prm\n"
                                     "end\n");
      EXPECT_EQ(entries_of(file), (List{"Adhesion/strength=1"}));
    }

    TEST(ParameterFile, the_same_file_twice_is_no_circle)
    {
      ScratchFolder folder;
      folder.write("base.prm", "set a = 1\n");
      const auto file =
        folder.write("main.prm", "include base.prm\ninclude base.prm\n");
      EXPECT_EQ(entries_of(file), (List{"a=1", "a=1"}));
    }

    TEST(ParameterFile, a_circle_of_includes_is_reported)
    {
      ScratchFolder folder;
      folder.write("b.prm", "set x = 1\ninclude a.prm\n");
      const auto file    = folder.write("a.prm", "include b.prm\n");
      const auto message = complaint_about(file);
      EXPECT_TRUE(contains(message, "circle")) << message;
      EXPECT_TRUE(contains(message, "b.prm:2")) << message;
    }

    TEST(ParameterFile, a_missing_include_names_file_and_line)
    {
      ScratchFolder folder;
      const auto    file =
        folder.write("a.prm", "set a = 1\n\ninclude nowhere.prm\n");
      const auto message = complaint_about(file);
      EXPECT_TRUE(contains(message, file + ":3")) << message;
      EXPECT_TRUE(contains(message, "nowhere.prm")) << message;
    }

    TEST(ParameterFile, a_missing_file_or_a_folder_is_reported)
    {
      ScratchFolder folder;
      EXPECT_TRUE(contains(complaint_about(folder / "no.prm"), "no.prm"));
      EXPECT_TRUE(contains(complaint_about(folder / "."), "folder"));
    }

    TEST(ParameterFile, each_mistake_names_its_line)
    {
      ScratchFolder folder;
      for (const auto &[text, place, words] :
           std::vector<std::tuple<std::string, std::string, std::string>>{
             {"\nstrength = 3\n", "a.prm:2", "cannot understand"},
             {"set strength 3\n", "a.prm:1", "lacks \"=\""},
             {"end\n", "a.prm:1", "without a \"subsection\""},
             {"include\n", "a.prm:1", "needs the name"},
             {"subsection A\nset b = 1\n", "a.prm", "lacks its \"end\""}})
        {
          const auto message = complaint_about(folder.write("a.prm", text));
          EXPECT_TRUE(contains(message, place)) << text << message;
          EXPECT_TRUE(contains(message, words)) << text << message;
        }
    }

    TEST(ParameterFile, an_included_file_cannot_close_a_section_it_did_not_open)
    {
      ScratchFolder folder;
      folder.write("b.prm", "end\nsubsection B\n");
      const auto message = complaint_about(
        folder.write("a.prm", "subsection A\ninclude b.prm\nend\n"));
      EXPECT_TRUE(contains(message, "b.prm:1")) << message;
    }

    TEST(ParameterFile, a_named_file_is_sought_beside_the_parameter_file)
    {
      ScratchFolder folder;
      folder.write("mesh.msh", "");
      const auto statements = read_parameter_file(
        folder.write("a.prm",
                     "set mesh file = mesh.msh\nset other file = none.msh\n"));
      ASSERT_EQ(statements.size(), 2u);
      EXPECT_EQ(statements[0].value, folder / "mesh.msh");
      EXPECT_EQ(statements[1].value, "none.msh");
    }
  } // namespace
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Values reach their entries, wrong ones are refused in words.
#include "base/parameter_entries.h"

#include "base/command_line.h"
#include "base/parameter_error.h"
#include "base/parameter_file.h"
#include "scratch_folder.h"

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <tuple>

namespace demold
{
  namespace
  {
    using namespace dealii;

    /// A program with some entries.
    struct Entries : testing::Test
    {
      Entries()
      {
        prm.add_parameter("dimension",
                          dimension,
                          "space [-]",
                          Patterns::Selection("2|3|axisymmetric"));
        prm.enter_subsection("Adhesion law");
        prm.add_parameter("rupture gap",
                          gap,
                          "delta_f gap at rupture [mm]",
                          Patterns::Double(0.));
        prm.add_parameter("angle", angle, "phi [degree]");
        prm.add_parameter("steps", steps, "n [-]", Patterns::Integer(1, 9));
        prm.leave_subsection();
      }

      std::string complaint_about(const std::string &path,
                                  const std::string &value)
      {
        return message_of<ExcParameter>([&]() {
          set_entries(prm, {{path, value}});
        });
      }

      std::string complaint_about_file(const std::string &text)
      {
        const auto file = folder.write("a.prm", text);
        return message_of<ExcParameter>(
          [&]() { set_entries(prm, read_parameter_file(file)); });
      }

      ParameterHandler prm;
      std::string      dimension = "2";
      double           gap       = 0.123456789;
      double           angle     = 1.;
      int              steps     = 3;
      ScratchFolder    folder;
    };

    TEST_F(Entries, a_file_fills_the_variables)
    {
      EXPECT_EQ(complaint_about_file("set dimension = axisymmetric\n"
                                     "subsection Adhesion law\n"
                                     "  set rupture gap = 0.25\n"
                                     "end\n"),
                "");
      EXPECT_EQ(dimension, "axisymmetric");
      EXPECT_EQ(gap, 0.25);
    }

    TEST_F(Entries, an_override_fills_the_variable)
    {
      set_entries(prm,
                  {{"Adhesion law/rupture gap", "0.5"}, {"dimension", "3"}});
      EXPECT_EQ(gap, 0.5);
      EXPECT_EQ(dimension, "3");
    }

    TEST_F(Entries, an_unknown_path_lists_the_nearest_names)
    {
      const auto message = complaint_about("Adhesion law/ruptur gap", "1");
      EXPECT_TRUE(contains(message, "\"Adhesion law/ruptur gap\"")) << message;
      EXPECT_TRUE(contains(message, "Nearest: \"Adhesion law/rupture gap\""))
        << message;
    }

    TEST_F(Entries, an_unknown_entry_in_a_file_names_line_and_neighbours)
    {
      const auto message = complaint_about_file("subsection Adhesion law\n"
                                                "  set rupture gab = 1\n"
                                                "end\n");
      EXPECT_TRUE(contains(message, "a.prm:2")) << message;
      EXPECT_TRUE(contains(message, "Nearest: \"Adhesion law/rupture gap\""))
        << message;
    }

    TEST_F(Entries, an_unknown_section_in_a_file_names_line_and_neighbours)
    {
      const auto message = complaint_about_file("\nsubsection Adhesion\nend\n");
      EXPECT_TRUE(contains(message, "a.prm:2")) << message;
      EXPECT_TRUE(contains(message, "no section \"Adhesion\"")) << message;
      EXPECT_TRUE(contains(message, "Nearest: \"Adhesion law\"")) << message;
    }

    TEST_F(Entries, a_wrong_value_is_refused_with_path_value_and_rule)
    {
      for (const auto &[path, value, rule] :
           std::vector<std::tuple<std::string, std::string, std::string>>{
             {"Adhesion law/rupture gap", "-1", "0 <= v"},
             {"Adhesion law/rupture gap", "1 mm", "0 <= v"},
             {"Adhesion law/rupture gap", "nan", "0 <= v"},
             {"Adhesion law/rupture gap", "1e999", "0 <= v"},
             {"Adhesion law/rupture gap", "", "0 <= v"},
             {"Adhesion law/steps", "2.5", "1 <= n <= 9"},
             {"Adhesion law/steps", "10", "1 <= n <= 9"},
             {"dimension", "4", "any one of 2, 3, axisymmetric"}})
        {
          const auto message = complaint_about(path, value);
          EXPECT_TRUE(contains(message, path)) << message;
          EXPECT_TRUE(contains(message, "got \"" + value + "\"")) << message;
          EXPECT_TRUE(contains(message, rule)) << message;
          EXPECT_FALSE(contains(message, "MAX_DOUBLE")) << message;
        }
      EXPECT_EQ(steps, 3);
    }

    TEST_F(Entries, an_unbounded_number_is_called_just_that)
    {
      EXPECT_TRUE(contains(complaint_about("Adhesion law/angle", "wide"),
                           "must be a floating point number, got \"wide\""));
    }

    TEST_F(Entries, the_printed_text_keeps_what_the_user_wrote)
    {
      set_entries(prm, {{"Adhesion law/rupture gap", "0.12345678901234"}});
      EXPECT_TRUE(
        contains(parameter_text(prm), "rupture gap = 0.12345678901234"));
    }

    TEST_F(Entries, a_printed_file_read_again_means_the_same)
    {
      use_printed_defaults(prm);
      const double used = gap; // 0.123456789 until now
      const auto   file = folder.write("used.prm", parameter_text(prm));
      gap               = -1.;
      set_entries(prm, read_parameter_file(file));
      EXPECT_EQ(gap, used);
    }

    TEST_F(Entries, declared_entries_come_in_order_with_documentation)
    {
      const auto entries = declared_entries(prm);
      ASSERT_EQ(entries.size(), 4u);
      EXPECT_EQ(joined_path(entries[0].path), "dimension");
      EXPECT_EQ(joined_path(entries[1].path), "Adhesion law/rupture gap");
      EXPECT_EQ(entries[1].documentation, "delta_f gap at rupture [mm]");
    }

    TEST_F(Entries, an_entry_without_default_must_be_given)
    {
      prm.enter_subsection("Adhesion law");
      prm.declare_entry("mesh file", "", Patterns::Anything(), "", true);
      prm.leave_subsection();
      use_printed_defaults(prm);
      const auto check = [this]() { check_mandatory_entries(prm); };
      EXPECT_TRUE(
        contains(message_of<ExcParameter>(check), "Adhesion law/mesh file: "));
      set_entries(prm, {{"Adhesion law/mesh file", "a.msh"}});
      EXPECT_EQ(message_of<ExcParameter>(check), "");
    }



    TEST(CommandLine, options_stand_before_or_after_the_scene)
    {
      const auto command = read_command_line({"--set",
                                              " A / b c = 1 = 2 ",
                                              "x y.prm",
                                              "--output=out dir",
                                              "--set=d=",
                                              "--restart",
                                              "old",
                                              "--quiet"});
      EXPECT_EQ(command.scene, "x y.prm");
      EXPECT_EQ(command.output, "out dir");
      EXPECT_EQ(command.restart, "old");
      EXPECT_TRUE(command.quiet);
      EXPECT_FALSE(command.check);
      ASSERT_EQ(command.overrides.size(), 2u);
      EXPECT_EQ(command.overrides[0].first, "A/b c");
      EXPECT_EQ(command.overrides[0].second, "1 = 2");
      EXPECT_EQ(command.overrides[1].first, "d");
      EXPECT_EQ(command.overrides[1].second, "");
    }

    TEST(CommandLine, what_cannot_be_understood_is_refused)
    {
      using Arguments = std::vector<std::string>;
      for (const auto &[arguments, words] :
           std::vector<std::pair<Arguments, std::string>>{
             {{"--set"}, "Section/Sub/entry=value"},
             {{"a.prm", "--set", "A/b"}, "got \"A/b\""},
             {{"--set", "=1"}, "Section/Sub/entry=value"},
             {{"--set", "a=1#2"}, "#"},
             {{"--output"}, "folder"},
             {{"--output="}, "folder"},
             {{"a.prm", "b.prm"}, "one parameter file"},
             {{""}, "empty"},
             {{"--chekc"}, "\"--check\""}})
        {
          const auto message =
            message_of<ExcParameter>([&]() { read_command_line(arguments); });
          EXPECT_TRUE(contains(message, words)) << words << ": " << message;
        }
    }
  } // namespace
} // namespace demold

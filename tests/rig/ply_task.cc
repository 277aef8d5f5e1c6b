// SPDX-License-Identifier: LGPL-2.1-or-later
// The ply task as its user meets it: numbers of theory A.5, tables, refusals.
#include "rig/ply_task.h"

#include "base/parameter_error.h"
#include "scratch_folder.h"

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace demold;

namespace
{
  PlyTask parsed_task(const std::string &entries)
  {
    dealii::ParameterHandler prm;
    PlyTask                  task;
    task.add_parameters(prm);
    prm.parse_input_from_string("subsection Ply\n" + entries + "\nend\n");
    return task;
  }

  RunStatus run_in(const ScratchFolder &scratch, const std::string &entries)
  {
    const PlyTask task = parsed_task(entries);
    task.check();
    RunContext context;
    context.output_folder = scratch.path;
    context.quiet         = true;
    return task.run(context);
  }

  std::vector<std::string> lines_of(const ScratchFolder &scratch,
                                    const std::string   &name)
  {
    std::ifstream            in(scratch / name);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
      lines.push_back(line);
    return lines;
  }
} // namespace

TEST(ply_task, reports_the_numbers_of_theory_within_one_percent)
{
  const ScratchFolder scratch;
  EXPECT_EQ(run_in(scratch, ""), RunStatus::completed);
  const auto summary =
    nlohmann::json::parse(std::ifstream(scratch / "summary.json"));
  EXPECT_EQ(summary["status"], "completed");
  for (const auto &[key, value] : std::vector<std::pair<std::string, double>>{
         {"cord volume fraction [-]", .152},
         {"E1 halpin-tsai [MPa]", 26200.},
         {"E2 halpin-tsai [MPa]", 9.23},
         {"E2 gough-tangorra [MPa]", 6.78},
         {"E2 akasaka-hirano [MPa]", 8.},
         {"G12 halpin-tsai [MPa]", 2.74},
         {"G12 gough-tangorra [MPa]", 1.70},
         {"G12 akasaka-hirano [MPa]", 2.},
         {"nu12 halpin-tsai [-]", .46},
         {"E_x akasaka-hirano [MPa]", 395.},
         {"E_y akasaka-hirano [MPa]", 7.1},
         {"G_xy akasaka-hirano [MPa]", 2700.},
         {"E_x akasaka closed form [MPa]", 395.}})
    EXPECT_NEAR(summary.at(key).get<double>(), value, .01 * value) << key;
}

TEST(ply_task, tabulates_from_rubber_to_the_largest_content_and_0_to_90_degree)
{
  const ScratchFolder scratch;
  run_in(scratch, "set points = 11\nset largest volume fraction = 0.5");
  const auto constants = lines_of(scratch, "constants.csv");
  const auto pair      = lines_of(scratch, "pair.csv");
  ASSERT_EQ(constants.size(), 12u);
  ASSERT_EQ(pair.size(), 12u);
  EXPECT_EQ(constants[0].substr(0, 45),
            "cord volume fraction [-],E1 halpin-tsai [MPa]");
  EXPECT_EQ(constants[1].substr(0, 6), "0,6,6,"); // the rubber alone
  EXPECT_EQ(constants[11].substr(0, 4), "0.5,");
  EXPECT_EQ(pair[0].substr(0, 15), "angle [degree],");
  EXPECT_EQ(pair[11].substr(0, 3), "90,");
  EXPECT_TRUE(std::filesystem::exists(scratch / "ply-constants.gp"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "pair-over-angle.gp"));
}

TEST(ply_task, refuses_cords_thicker_than_the_ply)
{
  const auto message = message_of<ExcParameter>(
    []() { parsed_task("set ply thickness = 0.4").check(); });
  EXPECT_TRUE(contains(message, "Ply/ply thickness")) << message;
  EXPECT_TRUE(contains(message, "got 0.4 mm")) << message;
}

TEST(ply_task, says_beforehand_what_it_will_compute)
{
  EXPECT_TRUE(contains(parsed_task("").preview(), "V_c = 0.152"));
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// The shipped belt ply has the constants of theory A.5.
#include "task_run.h"

#include <gtest/gtest.h>

namespace demold
{
  TEST(ply, has_the_constants_of_the_three_rules_within_one_percent)
  {
    const TaskRun                         run(shipped("ply.prm"));
    const std::pair<const char *, double> published[] = {
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
      {"G_xy akasaka-hirano [MPa]", 2700.}};
    for (const auto &[key, value] : published)
      EXPECT_NEAR(run.number(key), value, .01 * value) << key;
  }
} // namespace demold

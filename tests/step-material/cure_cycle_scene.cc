// SPDX-License-Identifier: LGPL-2.1-or-later
// The shipped press cycle cures as its header claims.
#include "task_run.h"

#include <gtest/gtest.h>

namespace demold
{
  TEST(cure_cycle, the_mould_side_is_done_and_the_rest_cures_on_in_air)
  {
    const TaskRun run(shipped("cure-cycle.prm"));
    const auto    opening = [&](const std::string &place) {
      return run.number("f90 " + place + " at the opening [-]");
    };
    const auto gain = [&](const std::string &place) {
      return run.number("f90 " + place + " [-]") - opening(place);
    };
    EXPECT_GT(opening("at the mould side"), 1.);
    EXPECT_LT(opening("in the middle"), 1.);
    EXPECT_LT(opening("at the back"), 1.);
    for (const char *const surface : {"at the mould side", "at the back"})
      {
        EXPECT_GT(gain(surface), 0.);
        EXPECT_GT(gain("in the middle"), gain(surface));
      }
    // Nowhere hotter than the hottest of what heats it.
    const CsvTable history = run.table("history.csv");
    for (const double T : history["temperature at 4 mm [degC]"])
      EXPECT_LT(T, 190.);
  }
} // namespace demold

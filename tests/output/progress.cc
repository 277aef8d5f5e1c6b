// SPDX-License-Identifier: LGPL-2.1-or-later
// The console tells where the run is and how long it will take.
#include "output/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace demold
{
  namespace
  {
    unsigned int count(const std::string &text, const std::string &part)
    {
      unsigned int n = 0;
      for (auto at = text.find(part); at != std::string::npos;
           at      = text.find(part, at + 1))
        ++n;
      return n;
    }

    TEST(Progress, durations_read_like_speech)
    {
      EXPECT_EQ(duration_text(0.4), "0 s");
      EXPECT_EQ(duration_text(59.), "59 s");
      EXPECT_EQ(duration_text(59.7), "1 min 00 s");
      EXPECT_EQ(duration_text(3600. * 2 + 60. * 5 + 7.), "2 h 05 min");
      EXPECT_EQ(duration_text(std::nan("")), "-");
      EXPECT_EQ(duration_text(1e300), "> 1000000 h");
    }

    TEST(Progress, the_time_left_extrapolates_the_pace_so_far)
    {
      EXPECT_DOUBLE_EQ(seconds_left(0., 0.25, 10.), 30.);
      // a restart at one half has done a quarter of the run in 10 s
      EXPECT_DOUBLE_EQ(seconds_left(0.5, 0.75, 10.), 10.);
      EXPECT_DOUBLE_EQ(seconds_left(0., 1., 10.), 0.);
      EXPECT_TRUE(std::isnan(seconds_left(0., 0., 10.)));
    }

    TEST(Progress, the_header_returns_every_twenty_lines)
    {
      std::ostringstream out;
      Progress           progress(out, false);
      for (unsigned int i = 0; i < 41; ++i)
        progress.print(IncrementLine());
      EXPECT_EQ(count(out.str(), "opening [mm]"), 3u);
      EXPECT_EQ(count(out.str(), "\n"), 44u);
    }

    TEST(Progress, a_line_shows_all_it_was_given)
    {
      std::ostringstream out;
      Progress           progress(out, false);
      progress.print({0.125, 2.5, -17.25, 4, 0.375, "arc length", 0.5});
      for (const char *const part :
           {"0.125", "2.5", "-17.25", " 4 ", "37.5 %", "arc length"})
        EXPECT_EQ(count(out.str(), part) > 0, true) << part << out.str();
    }

    TEST(Progress, what_a_step_does_not_have_is_a_dash)
    {
      std::ostringstream out;
      Progress           progress(out, false);
      IncrementLine      line;
      line.force = std::nan("");
      progress.print(line);
      EXPECT_EQ(count(out.str(), "nan"), 0u);
      EXPECT_GE(count(out.str(), " -"), 2u);
    }

    TEST(Progress, quiet_says_nothing)
    {
      std::ostringstream out;
      Progress           progress(out, true);
      progress.print(IncrementLine());
      progress.note("a remark");
      EXPECT_EQ(out.str(), "");
    }

    TEST(Progress, header_and_lines_are_aligned_within_eighty_columns)
    {
      std::ostringstream out;
      Progress           progress(out, false);
      progress.print({1.2345e-5, 2.5, -17.25, 4, 0.375, "quasi-static", 0.5});
      const std::string text   = out.str();
      const auto        header = text.find('\n');
      EXPECT_EQ(text.size(), 2 * (header + 1));
      EXPECT_LE(header, 80u);
    }
  } // namespace
} // namespace demold

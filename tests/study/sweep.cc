// SPDX-License-Identifier: LGPL-2.1-or-later
// Lists and ranges become the runs they describe.
#include "study/sweep.h"

#include "base/parameter_error.h"
#include "scratch_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demold
{
  namespace
  {
    using Texts = std::vector<std::string>;

    Sweep listed(const unsigned int number,
                 const std::string &entry,
                 const std::string &list)
    {
      Sweep sweep;
      sweep.section = "Sweep " + std::to_string(number);
      sweep.entry   = entry;
      sweep.list    = list;
      return sweep;
    }

    Sweep range(const double       from,
                const double       to,
                const unsigned int number,
                const std::string &scale)
    {
      Sweep sweep  = listed(1, "A/b", "");
      sweep.from   = from;
      sweep.to     = to;
      sweep.number = number;
      sweep.scale  = scale;
      return sweep;
    }
  } // namespace

  TEST(Sweep, separates_values_at_commas_unless_there_are_semicolons)
  {
    EXPECT_EQ(listed(1, "A/b", "q1, q1p0 ,q2").values(),
              (Texts{"q1", "q1p0", "q2"}));
    EXPECT_EQ(listed(1, "A/b", "2, 8; 4, 16").values(),
              (Texts{"2, 8", "4, 16"}));
    EXPECT_EQ(listed(1, "A/b", "2, 8;").values(), (Texts{"2, 8"}));
  }

  TEST(Sweep, ranges_have_equal_differences_or_ratios)
  {
    EXPECT_EQ(range(1., 2., 5, "linear").values(),
              (Texts{"1", "1.25", "1.5", "1.75", "2"}));
    EXPECT_EQ(range(.01, 100., 5, "logarithmic").values(),
              (Texts{"0.01", "0.1", "1", "10", "100"}));
    EXPECT_EQ(range(3., 3., 1, "logarithmic").values(), (Texts{"3"}));
  }

  TEST(Sweep, a_value_counts_by_its_first_number)
  {
    EXPECT_EQ(first_number("2, 8"), 2.);
    EXPECT_EQ(first_number("-1e-3"), -1e-3);
    EXPECT_TRUE(std::isnan(first_number("q2")));
    EXPECT_TRUE(std::isnan(first_number("2d")));
    EXPECT_TRUE(std::isnan(first_number("")));
  }

  TEST(Sweep, has_the_name_of_its_entry_unless_told_otherwise)
  {
    Sweep sweep = listed(1, "Body/fine size", "1");
    EXPECT_EQ(sweep.heading(), "fine size");
    EXPECT_EQ(sweep.name_in_formulas(), "fine_size");
    sweep.label = "h [mm]";
    EXPECT_EQ(sweep.heading(), "h [mm]");
    EXPECT_EQ(sweep.name_in_formulas(), "h");
    sweep.symbol = "size";
    EXPECT_EQ(sweep.name_in_formulas(), "size");
  }

  TEST(Combinations, are_all_with_the_last_varying_fastest)
  {
    const auto runs =
      combinations({listed(1, "a", "1, 2"), listed(2, "b", "x, y, z")});
    ASSERT_EQ(runs.size(), 6u);
    EXPECT_EQ(runs[0], (Texts{"1", "x"}));
    EXPECT_EQ(runs[1], (Texts{"1", "y"}));
    EXPECT_EQ(runs[5], (Texts{"2", "z"}));
  }

  TEST(Combinations, paired_values_go_in_step)
  {
    Sweep partner       = listed(3, "c", "10, 20");
    partner.paired_with = 1;
    const auto runs =
      combinations({listed(1, "a", "1, 2"), listed(2, "b", "x, y"), partner});
    ASSERT_EQ(runs.size(), 4u);
    for (const auto &run : runs)
      EXPECT_EQ(run[2], run[0] + "0");
  }

  TEST(Combinations, a_value_may_come_again_with_another_partner)
  {
    Sweep partner       = listed(2, "b", "x, y, x");
    partner.paired_with = 1;
    const auto runs     = combinations({listed(1, "a", "1, 1, 2"), partner});
    EXPECT_EQ(runs,
              (std::vector<Combination>{{"1", "x"}, {"1", "y"}, {"2", "x"}}));
  }

  TEST(Combinations, refuse_to_make_a_run_twice)
  {
    Sweep partner       = listed(2, "b", "x, y, x");
    partner.paired_with = 1;
    const auto message  = message_of<ExcParameter>([&]() {
      combinations({listed(1, "a", "1, 1, 1"), partner});
    });
    EXPECT_TRUE(contains(message, "Sweep 1/values")) << message;
    EXPECT_TRUE(contains(message, "\"1\" twice")) << message;
    EXPECT_TRUE(contains(message, "same of Sweep 2")) << message;
  }

  TEST(Combinations, paired_lists_must_be_equally_long)
  {
    Sweep partner       = listed(2, "b", "10, 20, 30");
    partner.paired_with = 1;
    const auto message  = message_of<ExcParameter>([&]() {
      combinations({listed(1, "a", "1, 2"), partner});
    });
    EXPECT_TRUE(contains(message, "Sweep 2/values")) << message;
    EXPECT_TRUE(contains(message, "2; got 3")) << message;
  }
} // namespace demold

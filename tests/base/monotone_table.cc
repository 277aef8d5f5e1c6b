// SPDX-License-Identifier: LGPL-2.1-or-later
// The tabulated curve meets its points and never overshoots.
#include "base/monotone_table.h"

#include <gtest/gtest.h>

#include <cmath>

using demold::MonotoneTable;

namespace
{
  const std::vector<double> x = {.5, .6, .8, 1., 1.2, 2.};
  const std::vector<double> y = {.05, .172, .752, .9, .954, .954};
} // namespace

TEST(monotone_table, meets_the_given_points)
{
  const MonotoneTable table(x, y);
  for (unsigned int i = 0; i < x.size(); ++i)
    EXPECT_DOUBLE_EQ(table(x[i]), y[i]);
  EXPECT_EQ(table.min(), .5);
  EXPECT_EQ(table.max(), 2.);
}

TEST(monotone_table, rises_where_its_points_rise_and_never_overshoots)
{
  const MonotoneTable table(x, y);
  double              last = table(.5);
  for (double at = .501; at < 2.; at += .001)
    {
      EXPECT_GE(table(at), last - 1e-15);
      EXPECT_LE(table(at), .954 + 1e-15);
      last = table(at);
    }
}

TEST(monotone_table, falls_where_its_points_fall)
{
  const MonotoneTable table({0., 1., 2., 3.}, {3., 2.9, .1, 0.});
  for (double at = .01; at < 3.; at += .01)
    EXPECT_LT(table(at), table(at - .01));
}

TEST(monotone_table, reproduces_a_straight_line)
{
  const MonotoneTable table({0., 1., 3., 4.}, {1., 3., 7., 9.});
  EXPECT_NEAR(table(2.3), 5.6, 1e-14);
}

TEST(monotone_table, does_not_extrapolate)
{
  const MonotoneTable table(x, y);
  EXPECT_TRUE(table.contains(2.));
  EXPECT_FALSE(table.contains(2.0001));
  EXPECT_FALSE(table.contains(std::nan("")));
  EXPECT_THROW(table(2.0001), std::out_of_range);
  EXPECT_THROW(table(.4999), std::out_of_range);
}

TEST(monotone_table, says_why_points_cannot_be_a_table)
{
  const auto why = [](const std::vector<double> &x,
                      const std::vector<double> &y) {
    return MonotoneTable::problem(x, y);
  };
  EXPECT_EQ(why(x, y), "");
  EXPECT_EQ(why({0., 1., 2.}, {0., 1., 2.}), "needs at least 4 points; got 3.");
  EXPECT_EQ(why({0., 1., 2., 3.}, {0., 1., 2.}),
            "needs one value per point; got 3 values for 4 points.");
  EXPECT_EQ(why({0., 1., 1., 3.}, {0., 1., 2., 3.}),
            "must increase strictly; got 1 after 1.");
  EXPECT_EQ(why({0., 1., 2., 3.}, {0., 1., 2., std::nan("")}),
            "needs finite numbers; point 4 is not.");
  EXPECT_THROW(MonotoneTable({0.}, {0.}), std::invalid_argument);
}

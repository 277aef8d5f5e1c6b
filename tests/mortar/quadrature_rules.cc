// SPDX-License-Identifier: LGPL-2.1-or-later
// The Gauss rules are exact to the degree they promise, and no further.
#include "mortar/quadrature_rules.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace demold;

namespace
{
  double integral(const TriangleRule &rule, const int i, const int j)
  {
    double sum = 0.;
    for (unsigned int g = 0; g < rule.n_points; ++g)
      sum += rule.weights[g] * std::pow(rule.points[g][0], i) *
             std::pow(rule.points[g][1], j);
    return sum;
  }

  /// Over the unit triangle: i! j!/(i + j + 2)!.
  double exact(const int i, const int j)
  {
    return std::tgamma(i + 1.) * std::tgamma(j + 1.) / std::tgamma(i + j + 3.);
  }

  bool exact_to(const TriangleRule &rule, const int degree)
  {
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j)
        if (std::abs(integral(rule, i, j) - exact(i, j)) > 1e-15)
          return false;
    return true;
  }
} // namespace

TEST(quadrature_rules, of_triangles_reach_degree_2_4_and_5)
{
  const unsigned int points[3]{3, 6, 7}, degree[3]{2, 4, 5};
  for (unsigned int k = 0; k < 3; ++k)
    {
      const TriangleRule &rule = triangle_rule(points[k]);
      EXPECT_EQ(rule.n_points, points[k]);
      EXPECT_TRUE(exact_to(rule, degree[k])) << points[k];
      EXPECT_FALSE(exact_to(rule, degree[k] + 1)) << points[k];
      for (unsigned int g = 0; g < rule.n_points; ++g)
        {
          EXPECT_GT(rule.weights[g], 0.);
          for (const double coordinate : rule.points[g])
            EXPECT_GT(coordinate, 0.);
        }
    }
}

TEST(quadrature_rules, of_intervals_reach_degree_2n_minus_1)
{
  for (unsigned int n = 1; n <= 4; ++n)
    for (unsigned int i = 0; i <= 2 * n; ++i)
      {
        const LineRule &rule = line_rule(n);
        double          sum  = 0.;
        for (unsigned int g = 0; g < rule.n_points; ++g)
          sum += rule.weights[g] * std::pow(rule.points[g], i);
        const double exact = i % 2 == 0 ? 2. / (i + 1.) : 0.;
        if (i < 2 * n)
          EXPECT_NEAR(sum, exact, 1e-15) << n << ' ' << i;
        else
          EXPECT_GT(std::abs(sum - exact), 1e-3) << n << ' ' << i;
      }
}

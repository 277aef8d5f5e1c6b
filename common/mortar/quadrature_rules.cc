// SPDX-License-Identifier: LGPL-2.1-or-later
// Gauss points of triangles and intervals.
#include "mortar/quadrature_rules.h"

#include <deal.II/base/exceptions.h>

#include <cmath>

namespace demold
{
  namespace
  {
    /// The three points with two coordinates equal to @p a; the weight sums
    /// up to 1 with the others.
    void add_orbit(TriangleRule &rule, const double a, const double weight)
    {
      for (unsigned int i = 0; i < 3; ++i)
        {
          std::array<double, 3> &point  = rule.points[rule.n_points];
          point                         = {{a, a, a}};
          point[i]                      = 1. - 2. * a;
          rule.weights[rule.n_points++] = 0.5 * weight;
        }
    }

    TriangleRule three_points()
    {
      TriangleRule rule;
      add_orbit(rule, 1. / 6., 1. / 3.);
      return rule;
    }

    TriangleRule six_points()
    {
      TriangleRule rule;
      const double ten    = std::sqrt(10.);
      const double shift  = std::sqrt(38. - 44. * std::sqrt(0.4));
      const double weight = std::sqrt(213125. - 53320. * ten);
      add_orbit(rule, (8. - ten + shift) / 18., (620. + weight) / 3720.);
      add_orbit(rule, (8. - ten - shift) / 18., (620. - weight) / 3720.);
      return rule;
    }

    TriangleRule seven_points()
    {
      TriangleRule rule;
      const double fifteen = std::sqrt(15.);
      add_orbit(rule, (6. - fifteen) / 21., (155. - fifteen) / 1200.);
      add_orbit(rule, (6. + fifteen) / 21., (155. + fifteen) / 1200.);
      rule.points[rule.n_points]    = {{1. / 3., 1. / 3., 1. / 3.}};
      rule.weights[rule.n_points++] = 0.5 * 9. / 40.;
      return rule;
    }

    std::array<LineRule, 4> line_rules()
    {
      std::array<LineRule, 4> rules;
      for (unsigned int n = 1; n <= 4; ++n)
        rules[n - 1].n_points = n;
      rules[0].weights = {{2., 0., 0., 0.}};
      const double two = std::sqrt(1. / 3.), three = std::sqrt(0.6);
      rules[1].points    = {{-two, two, 0., 0.}};
      rules[1].weights   = {{1., 1., 0., 0.}};
      rules[2].points    = {{-three, 0., three, 0.}};
      rules[2].weights   = {{5. / 9., 8. / 9., 5. / 9., 0.}};
      const double inner = std::sqrt(3. / 7. - 2. / 7. * std::sqrt(1.2));
      const double outer = std::sqrt(3. / 7. + 2. / 7. * std::sqrt(1.2));
      const double part  = std::sqrt(30.) / 36.;
      rules[3].points    = {{-outer, -inner, inner, outer}};
      rules[3].weights   = {{0.5 - part, 0.5 + part, 0.5 + part, 0.5 - part}};
      return rules;
    }
  } // namespace

  const TriangleRule &triangle_rule(const unsigned int n_points)
  {
    static const TriangleRule three = three_points(), six = six_points(),
                              seven = seven_points();
    Assert(n_points == 3 || n_points == 6 || n_points == 7,
           dealii::ExcIndexRange(n_points, 3, 8));
    return n_points == 3 ? three : n_points == 6 ? six : seven;
  }

  const LineRule &line_rule(const unsigned int n_points)
  {
    static const std::array<LineRule, 4> rules = line_rules();
    AssertIndexRange(n_points - 1, 4);
    return rules[n_points - 1];
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Gauss points of triangles and intervals.
#ifndef demold_mortar_quadrature_rules_h
#define demold_mortar_quadrature_rules_h

#include <array>

namespace demold
{
  /// Points in barycentric coordinates; the weights sum up to 1/2, to be
  /// multiplied with twice the area.
  struct TriangleRule
  {
    std::array<std::array<double, 3>, 7> points{};
    std::array<double, 7>                weights{};
    unsigned int                         n_points = 0;
  };

  /// 3 points, exact to degree 2; 6 points, degree 4 (Dunavant 1985); 7 points,
  /// degree 5 (Radon 1948). All points lie inside, all weights are positive.
  const TriangleRule &triangle_rule(const unsigned int n_points);

  /// Points in [-1,1]; the weights sum up to 2.
  struct LineRule
  {
    std::array<double, 4> points{};
    std::array<double, 4> weights{};
    unsigned int          n_points = 0;
  };

  /// Gauss-Legendre, 1 to 4 points.
  const LineRule &line_rule(const unsigned int n_points);
} // namespace demold

#endif

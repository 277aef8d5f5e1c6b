// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid planes, steps and corners: a polyline, extruded in 3-D.
#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

#include "geometry/test_bodies.h"

namespace demold
{
  using namespace dealii;

  namespace
  {
    // Theory B.11: patches end where neighbouring normals differ by more.
    constexpr double sharp_edge = 40 * numbers::PI / 180;

    struct DividedLine
    {
      std::vector<Point<2>>     points;
      std::vector<unsigned int> patch; // per segment
    };

    DividedLine divide(const RigidPolyline &polyline)
    {
      const auto &corners = polyline.corners;
      DividedLine line;
      line.points.push_back(corners[0]);
      unsigned int patch = 0;
      Tensor<1, 2> before;
      for (unsigned int i = 0; i + 1 < corners.size(); ++i)
        {
          const Tensor<1, 2> piece = corners[i + 1] - corners[i];
          const unsigned int n     = polyline.n_facets[i];
          AssertThrow(piece.norm() > 0 && n > 0,
                      ExcMessage("A polyline needs pieces of some length and "
                                 "at least one facet each."));
          const double turn =
            i == 0 ?
              0 :
              std::acos(
                std::max(-1., before * piece / before.norm() / piece.norm()));
          if (turn > sharp_edge)
            ++patch;
          for (unsigned int k = 1; k <= n; ++k)
            {
              line.points.push_back(k == n ? corners[i + 1] :
                                             corners[i] + piece * k / n);
              line.patch.push_back(patch);
            }
          before = piece;
        }
      return line;
    }
  } // namespace

  RigidSurface make_rigid_polyline(const RigidPolyline &polyline, const int dim)
  {
    AssertThrow(polyline.corners.size() >= 2 &&
                  polyline.n_facets.size() + 1 == polyline.corners.size() &&
                  (dim == 2 || (polyline.n_facets_y > 0 &&
                                polyline.y_end > polyline.y_begin)),
                ExcMessage("A polyline needs two corners or more, a number of "
                           "facets per piece and an extent along y."));
    const DividedLine  line = divide(polyline);
    const unsigned int n    = line.points.size();
    RigidSurface       surface;
    if (dim == 2)
      {
        for (const Point<2> &p : line.points)
          surface.vertices.emplace_back(p[0], p[1], 0);
        for (unsigned int i = 0; i + 1 < n; ++i)
          surface.facets.push_back({{{i, i + 1, 0, 0}}, 2});
        surface.patch = line.patch;
        return surface;
      }

    for (unsigned int j = 0; j <= polyline.n_facets_y; ++j)
      for (const Point<2> &p : line.points)
        surface.vertices.emplace_back(p[0],
                                      polyline.y_begin +
                                        (polyline.y_end - polyline.y_begin) *
                                          j / polyline.n_facets_y,
                                      p[1]);
    for (unsigned int j = 0; j < polyline.n_facets_y; ++j)
      for (unsigned int i = 0; i + 1 < n; ++i)
        {
          // e_y x t is the 2-D normal (t_y, -t_x) drawn in x-z.
          const unsigned int near = j * n + i, far = near + n;
          surface.facets.push_back({{{near, far, far + 1, near + 1}}, 4});
          surface.patch.push_back(line.patch[i]);
        }
    return surface;
  }

  RigidSurface make_rigid_plane(const Point<2>                    &from,
                                const Point<2>                    &to,
                                const double                       level,
                                const std::array<unsigned int, 2> &n_facets,
                                const int                          dim)
  {
    RigidPolyline line;
    line.corners    = {{to[0], level}, {from[0], level}};
    line.n_facets   = {n_facets[0]};
    line.y_begin    = from[1];
    line.y_end      = to[1];
    line.n_facets_y = n_facets[1];
    return make_rigid_polyline(line, dim);
  }
} // namespace demold

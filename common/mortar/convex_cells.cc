// SPDX-License-Identifier: LGPL-2.1-or-later
// A projected face as one convex quadrilateral or as triangles.
#include "mortar/convex_cells.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  namespace
  {
    /// Twice the signed area of the triangle a, b, c.
    double turn(const PlaneVector<double> &a,
                const PlaneVector<double> &b,
                const PlaneVector<double> &c)
    {
      return cross(difference(b, a), difference(c, a));
    }

    void add_triangle(ConvexCells                       &result,
                      const PlaneNodes<double>          &y,
                      const double                       orientation,
                      const std::array<unsigned int, 3> &n)
    {
      if (!(orientation * turn(y[n[0]], y[n[1]], y[n[2]]) > 0.))
        return;
      ConvexCell &cell = result.cells[result.n_cells++];
      cell.n_nodes     = 3;
      if (orientation > 0.)
        cell.nodes = {{n[0], n[1], n[2], 0}};
      else
        cell.nodes = {{n[0], n[2], n[1], 0}};
    }
  } // namespace

  double signed_area(const PlaneNodes<double> &y)
  {
    return 0.5 * cross(difference(y[2], y[0]), difference(y[3], y[1]));
  }

  ConvexCells convex_cells(const PlaneNodes<double> &y)
  {
    ConvexCells  result;
    const double area = signed_area(y);
    if (!(std::abs(area) > 0.))
      return result;
    const double orientation = area > 0. ? 1. : -1.;

    // The corner that turns most against the whole.
    unsigned int worst      = 0;
    double       worst_turn = 0.;
    for (unsigned int i = 0; i < 4; ++i)
      {
        const double t =
          orientation * turn(y[(i + 3) % 4], y[i], y[(i + 1) % 4]);
        if (i == 0 || t < worst_turn)
          {
            worst      = i;
            worst_turn = t;
          }
      }

    // Rounding may dent a corner of 180 degree.
    if (worst_turn >= -1e-13 * std::abs(area))
      {
        result.n_cells        = 1;
        result.cells[0].nodes = {{0, 1, 2, 3}};
        if (orientation < 0.)
          result.cells[0].nodes = {{0, 3, 2, 1}};
        result.cells[0].n_nodes = 4;
        return result;
      }
    const unsigned int i = worst, j = (worst + 1) % 4, k = (worst + 2) % 4,
                       l = (worst + 3) % 4;
    add_triangle(result, y, orientation, {{i, j, k}});
    add_triangle(result, y, orientation, {{i, k, l}});
    return result;
  }
} // namespace demold

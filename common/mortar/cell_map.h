// SPDX-License-Identifier: LGPL-2.1-or-later
// Shape functions of a face at a point of the auxiliary plane.
#ifndef demold_mortar_cell_map_h
#define demold_mortar_cell_map_h

#include "mortar/convex_cells.h"
#include "mortar/plane_vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace demold
{
  /// From parameters to points of a cell and back:
  ///
  ///     y(xi) = c_0 + c_1 xi_1 + c_2 xi_2 + c_3 xi_1 xi_2,
  ///
  /// bilinear on [-1,1]^2 for four nodes; linear on the unit triangle, with
  /// c_3 = 0, for three.
  class CellMap
  {
  public:
    CellMap(const ConvexCell &cell, const PlaneNodes<double> &y)
      : cell(cell)
    {
      const std::array<unsigned int, 4> &n = cell.nodes;
      for (unsigned int i = 0; i < 2; ++i)
        if (cell.n_nodes == 3)
          {
            c0[i] = y[n[0]][i];
            c1[i] = y[n[1]][i] - y[n[0]][i];
            c2[i] = y[n[2]][i] - y[n[0]][i];
          }
        else
          {
            const double diagonal_02 = y[n[0]][i] + y[n[2]][i],
                         diagonal_13 = y[n[1]][i] + y[n[3]][i];
            const double across_02   = y[n[2]][i] - y[n[0]][i],
                         across_13   = y[n[3]][i] - y[n[1]][i];
            c0[i]                    = 0.25 * (diagonal_02 + diagonal_13);
            c1[i]                    = 0.25 * (across_02 - across_13);
            c2[i]                    = 0.25 * (across_02 + across_13);
            c3[i]                    = 0.25 * (diagonal_02 - diagonal_13);
          }
    }

    /// Parameters of a point (theory B.5, in the plane): the root of
    ///
    ///     A xi_1^2 + B xi_1 + C = 0,   r = y - c_0,   A = -c_1 x c_3,
    ///     B = r x c_3 - c_1 x c_2,     C = r x c_2
    ///
    /// that exists for c_3 = 0. Its discriminant is the square of the
    /// Jacobian, so it is real and simple inside of every convex cell. The
    /// nodes run counter-clockwise, so the root is negative in B - root, which
    /// loses no digits.
    PlaneVector<double> parameters(const PlaneVector<double> &y) const
    {
      const PlaneVector<double> r = difference(y, c0);
      const double A = -cross(c1, c3), B = cross(r, c3) - cross(c1, c2),
                   C    = cross(r, c2);
      const double root = std::sqrt(std::max(B * B - 4. * A * C, 0.));
      const double xi   = -2. * C / (B - root);
      const auto   along =
        PlaneVector<double>{{c2[0] + xi * c3[0], c2[1] + xi * c3[1]}};
      const auto offset =
        PlaneVector<double>{{r[0] - xi * c1[0], r[1] - xi * c1[1]}};
      return {{xi, dot(offset, along) / dot(along, along)}};
    }

    /// dxi/dy [1/mm], rows by parameter.
    std::array<PlaneVector<double>, 2>
    parameter_derivatives(const PlaneVector<double> &xi) const
    {
      const PlaneVector<double> j1{
        {c1[0] + xi[1] * c3[0], c1[1] + xi[1] * c3[1]}},
        j2{{c2[0] + xi[0] * c3[0], c2[1] + xi[0] * c3[1]}};
      const double scale = 1. / cross(j1, j2);
      return {
        {{{scale * j2[1], -scale * j2[0]}}, {{-scale * j1[1], scale * j1[0]}}}};
    }

    const ConvexCell &cell;

  private:
    PlaneVector<double> c0{}, c1{}, c2{}, c3{};
  };

  /// Shape functions of the corners of a cell, in the order of
  /// ConvexCell::nodes.
  template <typename Number>
  std::array<Number, 4> corner_functions(const unsigned int         n_nodes,
                                         const PlaneVector<Number> &xi)
  {
    if (n_nodes == 3)
      return {{1. - xi[0] - xi[1], xi[0], xi[1], Number(0.)}};
    const Number a = 0.5 * (1. - xi[0]), b = 0.5 * (1. + xi[0]);
    const Number c = 0.5 * (1. - xi[1]), d = 0.5 * (1. + xi[1]);
    return {{a * c, b * c, b * d, a * d}};
  }

  /// Their derivatives by the parameters.
  inline std::array<std::array<double, 2>, 4>
  corner_derivatives(const unsigned int n_nodes, const PlaneVector<double> &xi)
  {
    if (n_nodes == 3)
      return {{{{-1., -1.}}, {{1., 0.}}, {{0., 1.}}, {{0., 0.}}}};
    const double a = 0.25 * (1. - xi[0]), b = 0.25 * (1. + xi[0]);
    const double c = 0.25 * (1. - xi[1]), d = 0.25 * (1. + xi[1]);
    return {{{{-c, -a}}, {{c, -b}}, {{d, b}}, {{-d, a}}}};
  }

  /// Parameters of the point @p y in a cell of the face with the projected
  /// nodes @p nodes: those of the values, and for numbers with derivatives one
  /// step of Newton's method from there, which makes the derivatives exact
  /// (implicit function theorem).
  template <typename Number>
  PlaneVector<Number> cell_parameters(const CellMap             &map,
                                      const PlaneNodes<Number>  &nodes,
                                      const PlaneVector<Number> &y)
  {
    const PlaneVector<double> xi = map.parameters(value_of(y));
    if constexpr (std::is_same<Number, double>::value)
      return xi;
    const auto          N       = corner_functions(map.cell.n_nodes, xi);
    const auto          inverse = map.parameter_derivatives(xi);
    PlaneVector<Number> r       = y;
    for (unsigned int a = 0; a < map.cell.n_nodes; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        r[i] -= N[a] * nodes[map.cell.nodes[a]][i];
    return {{xi[0] + inverse[0][0] * r[0] + inverse[0][1] * r[1],
             xi[1] + inverse[1][0] * r[0] + inverse[1][1] * r[1]}};
  }

  /// Shape functions of the nodes of the face at that point, zero for a node
  /// that is none of the cell's.
  template <typename Number>
  std::array<Number, 4> shape_functions(const CellMap             &map,
                                        const PlaneNodes<Number>  &nodes,
                                        const PlaneVector<Number> &y)
  {
    const std::array<Number, 4> corner =
      corner_functions(map.cell.n_nodes, cell_parameters(map, nodes, y));
    std::array<Number, 4> N{{Number(0.), Number(0.), Number(0.), Number(0.)}};
    for (unsigned int a = 0; a < map.cell.n_nodes; ++a)
      N[map.cell.nodes[a]] = corner[a];
    return N;
  }
} // namespace demold

#endif

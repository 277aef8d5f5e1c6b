// SPDX-License-Identifier: LGPL-2.1-or-later
// Shape functions of a face at a point of the auxiliary plane.
#ifndef demold_mortar_cell_map_h
#define demold_mortar_cell_map_h

#include "mortar/convex_cells.h"
#include "mortar/plane_vector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace demold
{
  /// The shape functions at the corners of a cell, in the order of
  /// ConvexCell::nodes, and their derivatives by the parameters.
  template <typename Number>
  struct CellShape
  {
    std::array<Number, 4>                N{};
    std::array<std::array<Number, 2>, 4> dN{};
  };

  /// Bilinear on [-1,1]^2 for four nodes; linear on the unit triangle for
  /// three.
  template <typename Number>
  CellShape<Number> cell_shape(const unsigned int         n_nodes,
                               const PlaneVector<Number> &xi)
  {
    CellShape<Number> shape;
    if (n_nodes == 3)
      {
        shape.N  = {{1. - xi[0] - xi[1], xi[0], xi[1], Number(0.)}};
        shape.dN = {{{{Number(-1.), Number(-1.)}},
                     {{Number(1.), Number(0.)}},
                     {{Number(0.), Number(1.)}},
                     {{Number(0.), Number(0.)}}}};
        return shape;
      }
    const Number a = 0.5 * (1. - xi[0]), b = 0.5 * (1. + xi[0]);
    const Number c = 0.5 * (1. - xi[1]), d = 0.5 * (1. + xi[1]);
    shape.N  = {{a * c, b * c, b * d, a * d}};
    shape.dN = {{{{-0.5 * c, -0.5 * a}},
                 {{0.5 * c, -0.5 * b}},
                 {{0.5 * d, 0.5 * b}},
                 {{-0.5 * d, 0.5 * a}}}};
    return shape;
  }

  /// Parameters of a point @p y of the plane in a cell with the corners @p x.
  /// That of theory B.5 in the plane: sum N_a(xi) x_a = y. For four nodes the
  /// root of
  ///
  ///     A xi^2 + B xi + C = 0,   C = r x c_2,  B = r x c_3 - c_1 x c_2,
  ///     A = -c_1 x c_3,   r = y - c_0,   x(xi) = c_0 + c_1 xi_1 + c_2 xi_2
  ///                                              + c_3 xi_1 xi_2
  ///
  /// that exists in a parallelogram; its discriminant is the square of the
  /// Jacobian, so it is real and simple inside of every convex cell.
  inline PlaneVector<double>
  cell_parameters(const std::array<PlaneVector<double>, 4> &x,
                  const unsigned int                        n_nodes,
                  const PlaneVector<double>                &y)
  {
    if (n_nodes == 3)
      {
        const auto   a = difference(x[1], x[0]), b = difference(x[2], x[0]);
        const auto   r    = difference(y, x[0]);
        const double size = cross(a, b);
        return {{cross(r, b) / size, cross(a, r) / size}};
      }
    PlaneVector<double> r, c1, c2, c3;
    for (unsigned int i = 0; i < 2; ++i)
      {
        r[i]  = y[i] - 0.25 * (x[0][i] + x[1][i] + x[2][i] + x[3][i]);
        c1[i] = 0.25 * (-x[0][i] + x[1][i] + x[2][i] - x[3][i]);
        c2[i] = 0.25 * (-x[0][i] - x[1][i] + x[2][i] + x[3][i]);
        c3[i] = 0.25 * (x[0][i] - x[1][i] + x[2][i] - x[3][i]);
      }
    const double A = -cross(c1, c3), B = cross(r, c3) - cross(c1, c2),
                 C    = cross(r, c2);
    const double root = std::sqrt(std::max(B * B - 4. * A * C, 0.));
    const double xi   = -2. * C / (B - root);
    const auto   line =
      PlaneVector<double>{{c2[0] + xi * c3[0], c2[1] + xi * c3[1]}};
    const auto offset =
      PlaneVector<double>{{r[0] - xi * c1[0], r[1] - xi * c1[1]}};
    return {{xi, dot(offset, line) / dot(line, line)}};
  }

  /// Inverse of the Jacobian dx/dxi [1/mm]: rows by parameter.
  inline std::array<PlaneVector<double>, 2>
  inverse_jacobian(const CellShape<double>                  &shape,
                   const std::array<PlaneVector<double>, 4> &x,
                   const unsigned int                        n_nodes)
  {
    PlaneVector<double> j1{}, j2{};
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        {
          j1[i] += shape.dN[a][0] * x[a][i];
          j2[i] += shape.dN[a][1] * x[a][i];
        }
    const double det = cross(j1, j2);
    return {{{{j2[1] / det, -j2[0] / det}}, {{-j1[1] / det, j1[0] / det}}}};
  }

  /// One step of Newton's method from parameters @p xi that solve on values.
  /// Its derivatives are exact (implicit function theorem).
  template <typename Number>
  PlaneVector<Number> newton_step(const std::array<PlaneVector<Number>, 4> &x,
                                  const unsigned int         n_nodes,
                                  const PlaneVector<Number> &y,
                                  const PlaneVector<double> &xi)
  {
    const CellShape<double>                  shape = cell_shape(n_nodes, xi);
    const std::array<PlaneVector<double>, 2> inverse =
      inverse_jacobian(shape, value_of(x), n_nodes);
    PlaneVector<Number> r = y;
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        r[i] -= shape.N[a] * x[a][i];
    return {{xi[0] + inverse[0][0] * r[0] + inverse[0][1] * r[1],
             xi[1] + inverse[1][0] * r[0] + inverse[1][1] * r[1]}};
  }

  /// The positions of the corners of a cell.
  template <typename Number>
  std::array<PlaneVector<Number>, 4> cell_corners(const ConvexCell &cell,
                                                  const PlaneNodes<Number> &y)
  {
    return {
      {y[cell.nodes[0]], y[cell.nodes[1]], y[cell.nodes[2]], y[cell.nodes[3]]}};
  }

  /// Shape functions of the nodes of the face at a point @p y of a cell with
  /// the corners @p x, zero for a node that is none of the cell's.
  template <typename Number>
  std::array<Number, 4>
  shape_functions(const ConvexCell                         &cell,
                  const std::array<PlaneVector<Number>, 4> &x,
                  const PlaneVector<Number>                &y)
  {
    const PlaneVector<double> start =
      cell_parameters(value_of(x), cell.n_nodes, value_of(y));
    const PlaneVector<Number> xi    = newton_step(x, cell.n_nodes, y, start);
    const CellShape<Number>   shape = cell_shape(cell.n_nodes, xi);
    std::array<Number, 4> N{{Number(0.), Number(0.), Number(0.), Number(0.)}};
    for (unsigned int a = 0; a < cell.n_nodes; ++a)
      N[cell.nodes[a]] = shape.N[a];
    return N;
  }
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Integrals over a segment and their derivatives by coordinates in the plane.
#include "mortar/segment_gradients.h"

#include "mortar/cell_map.h"
#include "mortar/fan.h"

#include <cmath>
#include <tuple>

namespace demold
{
  namespace
  {
    using Vector   = PlaneVector<double>;
    using Gradient = PlaneVector<IntegralRow>;
    /// Adds to the first @p n integrals.
    template <unsigned int n = std::tuple_size<IntegralRow>::value>
    void add(const double factor, const IntegralRow &row, IntegralRow &sum)
    {
      const double *__restrict from = row.data();
      double *__restrict to         = sum.data();
      for (unsigned int q = 0; q < n; ++q)
        to[q] += factor * from[q];
    }

    void add(const double factor, const Gradient &gradient, Gradient &sum)
    {
      add(factor, gradient[0], sum[0]);
      add(factor, gradient[1], sum[1]);
    }

    /// Adds @p matrix^T times @p gradient: the chain rule for a point that
    /// moves by @p matrix times the change of another.
    void add(const std::array<Vector, 2> &matrix,
             const Gradient              &gradient,
             Gradient                    &sum)
    {
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          add(matrix[i][j], gradient[i], sum[j]);
    }

    /// Shape functions of a face at a point and their gradients in the plane.
    struct FacePoint
    {
      std::array<double, 4>                N{};
      std::array<std::array<double, 4>, 2> dN{}; ///< [1/mm] by direction
    };

    FacePoint face_point(const CellMap &map, const Vector &y)
    {
      const Vector xi      = map.parameters(y);
      const auto   N       = corner_functions(map.cell.n_nodes, xi);
      const auto   dN      = corner_derivatives(map.cell.n_nodes, xi);
      const auto   inverse = map.parameter_derivatives(xi);
      FacePoint    point;
      for (unsigned int a = 0; a < map.cell.n_nodes; ++a)
        {
          const unsigned int node = map.cell.nodes[a];
          point.N[node]           = N[a];
          for (unsigned int c = 0; c < 2; ++c)
            point.dN[c][node] =
              dN[a][0] * inverse[0][c] + dN[a][1] * inverse[1][c];
        }
      return point;
    }

    void set_integrands(const FacePoint &slave,
                        const FacePoint &master,
                        IntegralRow     &f)
    {
      for (unsigned int A = 0; A < 4; ++A)
        {
          for (unsigned int C = 0; C < 3; ++C)
            f[M_integral(A, C)] = slave.N[A] * master.N[C];
          for (unsigned int B = A; B < 4; ++B)
            f[D_integral(A, B)] = slave.N[A] * slave.N[B];
        }
    }

    /// Gradients of the integrands, times @p W, through the parameters on the
    /// slave and on the master. The latter only of M.
    void set_gradients(const double     W,
                       const FacePoint &slave,
                       const FacePoint &master,
                       Gradient        &through_slave,
                       Gradient        &through_master)
    {
      for (unsigned int c = 0; c < 2; ++c)
        for (unsigned int A = 0; A < 4; ++A)
          {
            const double dN_A = W * slave.dN[c][A], N_A = W * slave.N[A];
            for (unsigned int C = 0; C < 3; ++C)
              {
                through_slave[c][M_integral(A, C)]  = dN_A * master.N[C];
                through_master[c][M_integral(A, C)] = N_A * master.dN[c][C];
              }
            for (unsigned int B = A; B < 4; ++B)
              through_slave[c][D_integral(A, B)] =
                dN_A * slave.N[B] + N_A * slave.dN[c][B];
          }
    }

    /// What depends on the corners of one triangle of the fan.
    struct TriangleGradients
    {
      IntegralRow             by_det{};
      std::array<Gradient, 3> by_corner{};
    };

    /// Integrates one triangle with the corners @p y; adds to the value and,
    /// at fixed Gauss points, to the derivatives by the nodes.
    TriangleGradients integrate_triangle(const std::array<Vector, 3> &y,
                                         const double                 det,
                                         const CellMap               &slave,
                                         const CellMap               &master,
                                         const TriangleRule          &rule,
                                         PlaneGradients              &sums)
    {
      TriangleGradients result;
      IntegralRow       f{};
      Gradient          through{}, through_master{};
      for (unsigned int g = 0; g < rule.n_points; ++g)
        {
          Vector point{};
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int c = 0; c < 2; ++c)
              point[c] += rule.points[g][i] * y[i][c];
          const FacePoint on_slave  = face_point(slave, point);
          const FacePoint on_master = face_point(master, point);
          const double    W         = rule.weights[g] * det;
          set_integrands(on_slave, on_master, f);
          set_gradients(W, on_slave, on_master, through, through_master);

          add(W, f, sums.value);
          add(rule.weights[g], f, result.by_det);
          for (unsigned int c = 0; c < 2; ++c)
            {
              for (unsigned int I = 0; I < 4; ++I)
                add(-on_slave.N[I], through[c], sums.nodes[I][c]);
              for (unsigned int J = 0; J < 3; ++J)
                add<n_M_integrals>(-on_master.N[J],
                                   through_master[c],
                                   sums.nodes[4 + J][c]);
              add<n_M_integrals>(1., through_master[c], through[c]);
              for (unsigned int i = 0; i < 3; ++i)
                add(rule.points[g][i], through[c], result.by_corner[i][c]);
            }
        }
      return result;
    }

    /// d centre / d y_i of fan_centre(). The point from which moments are
    /// taken counts as fixed: the centroid does not depend on it.
    std::array<Vector, 2> centre_derivative(const SegmentPositions<double> &y,
                                            const unsigned int              n,
                                            const unsigned int              i,
                                            const Vector &centre,
                                            const double  twice_area)
    {
      const Vector          next      = difference(y[(i + 1) % n], centre);
      const Vector          here      = difference(y[i], centre);
      const Vector          previous  = difference(y[(i + n - 1) % n], centre);
      const double          part_next = cross(here, next);
      const double          part_prev = cross(previous, here);
      std::array<Vector, 2> result;
      for (unsigned int c = 0; c < 2; ++c)
        {
          const double sum_next = here[c] + next[c];
          const double sum_prev = here[c] + previous[c];
          result[c] = {{(sum_next * next[1] - sum_prev * previous[1]),
                        (sum_prev * previous[0] - sum_next * next[0])}};
          result[c][c] += part_next + part_prev;
          for (double &entry : result[c])
            entry /= 3. * twice_area;
        }
      return result;
    }

    void add_to_master(const unsigned int node,
                       const double       factor,
                       const Gradient    &gradient,
                       PlaneGradients    &sums)
    {
      if (node < 3)
        add(factor, gradient, sums.nodes[4 + node]);
    }

    /// Carries the derivatives by a vertex to the nodes. With the crossing at
    /// the shares s and u of its edges e_s and e_m, and v the velocity of the
    /// master edge there relative to the slave edge,
    ///
    ///     dy = (1-s) dx_1 + s dx_2 + e_s ds,  ds = (v x e_m)/(e_s x e_m).
    void carry_to_nodes(const SegmentVertex      &vertex,
                        const PlaneNodes<double> &slave,
                        const PlaneNodes<double> &master,
                        const Gradient           &by_vertex,
                        PlaneGradients           &sums)
    {
      using Origin = SegmentVertex::Origin;
      if (vertex.origin == Origin::slave_node)
        return add(1., by_vertex, sums.nodes[vertex.slave[0]]);
      if (vertex.origin == Origin::master_node)
        return add_to_master(vertex.master[0], 1., by_vertex, sums);

      const Vector x1 = slave[vertex.slave[0]], y1 = master[vertex.master[0]];
      const Vector e_s  = difference(slave[vertex.slave[1]], x1);
      const Vector e_m  = difference(master[vertex.master[1]], y1);
      const Vector from = difference(y1, x1);
      const double den  = cross(e_s, e_m);
      const double s = cross(from, e_m) / den, u = cross(from, e_s) / den;

      IntegralRow by_s{};
      add(e_s[0] / den, by_vertex[0], by_s);
      add(e_s[1] / den, by_vertex[1], by_s);
      Gradient by_slave = by_vertex, by_master{};
      add(e_m[1], by_s, by_master[0]);
      add(-e_m[0], by_s, by_master[1]);
      add(-1., by_master, by_slave);
      add(1. - s, by_slave, sums.nodes[vertex.slave[0]]);
      add(s, by_slave, sums.nodes[vertex.slave[1]]);
      add_to_master(vertex.master[0], 1. - u, by_master, sums);
      add_to_master(vertex.master[1], u, by_master, sums);
    }
  } // namespace

  void add_segment_gradients(const Segment3d          &segment,
                             const PlaneNodes<double> &slave,
                             const PlaneNodes<double> &master,
                             const TriangleRule       &rule,
                             PlaneGradients           &sums)
  {
    const double       slave_area = std::abs(signed_area(slave));
    const unsigned int n          = segment.n_vertices;
    const auto         y          = segment_positions(segment, slave, master);
    const Vector       centre     = fan_centre(y, n, slave_area);
    const CellMap      on_slave(segment.slave, slave);
    const CellMap      on_master(segment.master, master);

    std::array<Gradient, Segment3d::max_vertices> by_vertex{};
    Gradient                                      by_centre{};
    double                                        twice_area = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        const unsigned int j   = (i + 1) % n;
        const Vector       a   = difference(y[i], centre);
        const Vector       b   = difference(y[j], centre);
        const double       det = cross(a, b);
        twice_area += det;
        TriangleGradients t = integrate_triangle({{centre, y[i], y[j]}},
                                                 det,
                                                 on_slave,
                                                 on_master,
                                                 rule,
                                                 sums);
        add(b[1], t.by_det, t.by_corner[1][0]);
        add(-b[0], t.by_det, t.by_corner[1][1]);
        add(-a[1], t.by_det, t.by_corner[2][0]);
        add(a[0], t.by_det, t.by_corner[2][1]);
        add(a[1] - b[1], t.by_det, t.by_corner[0][0]);
        add(b[0] - a[0], t.by_det, t.by_corner[0][1]);
        add(1., t.by_corner[0], by_centre);
        add(1., t.by_corner[1], by_vertex[i]);
        add(1., t.by_corner[2], by_vertex[j]);
      }

    const bool sliver = !has_centroid(twice_area, slave_area);
    for (unsigned int i = 0; i < n; ++i)
      {
        if (sliver)
          add(1. / n, by_centre, by_vertex[i]);
        else
          add(centre_derivative(y, n, i, centre, twice_area),
              by_centre,
              by_vertex[i]);
        carry_to_nodes(segment.vertices[i], slave, master, by_vertex[i], sums);
      }
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies of the mortar integrals, for any number.
#ifndef demold_mortar_pair_integrals_templates_h
#define demold_mortar_pair_integrals_templates_h

#include "mortar/auxiliary_plane.h"
#include "mortar/cell_map.h"
#include "mortar/fan.h"
#include "mortar/pair_integrals.h"
#include "mortar/quadrature_rules.h"
#include "mortar/segment_2d.h"
#include "mortar/segment_3d.h"

#include <deal.II/base/numbers.h>

namespace demold
{
  /// Adds the contribution of one Gauss point of weight @p W [mm^2].
  template <typename Number>
  void add_point(const Number                &W,
                 const std::array<Number, 4> &N_slave,
                 const std::array<Number, 4> &N_master,
                 const unsigned int           n_nodes,
                 PairIntegrals<Number>       &sums)
  {
    sums.area += W;
    for (unsigned int A = 0; A < n_nodes; ++A)
      {
        const Number weighted = W * N_slave[A];
        for (unsigned int B = 0; B < n_nodes; ++B)
          {
            sums.D[A][B] += weighted * N_slave[B];
            sums.M[A][B] += weighted * N_master[B];
          }
      }
  }

  /// Adds a segment in 3-D: the triangles around its centroid (theory B.4).
  template <typename Number>
  void add_segment(const Segment3d          &segment,
                   const PlaneNodes<Number> &slave,
                   const PlaneNodes<Number> &master,
                   const TriangleRule       &rule,
                   PairIntegrals<Number>    &sums)
  {
    const double slave_area = std::abs(signed_area(value_of(slave)));
    const SegmentPositions<Number> y =
      segment_positions(segment, slave, master);
    const PlaneVector<Number> centre =
      fan_centre(y, segment.n_vertices, slave_area);
    const CellMap on_slave(segment.slave, value_of(slave));
    const CellMap on_master(segment.master, value_of(master));
    for (unsigned int i = 0; i < segment.n_vertices; ++i)
      {
        const PlaneVector<Number> &a = y[i],
                                  &b = y[(i + 1) % segment.n_vertices];
        const Number det = cross(difference(a, centre), difference(b, centre));
        for (unsigned int g = 0; g < rule.n_points; ++g)
          {
            const std::array<double, 3> &t = rule.points[g];
            PlaneVector<Number>          point;
            for (unsigned int c = 0; c < 2; ++c)
              point[c] = t[0] * centre[c] + t[1] * a[c] + t[2] * b[c];
            add_point(Number(rule.weights[g] * det),
                      shape_functions(on_slave, slave, point),
                      shape_functions(on_master, master, point),
                      4,
                      sums);
          }
      }
  }

  /// Shape functions of a line at the position @p s along the slave.
  template <typename Number>
  std::array<Number, 4> line_shape(const PlaneNodes<Number> &line,
                                   const Number             &s)
  {
    const Number t = (s - line[0][0]) / (line[1][0] - line[0][0]);
    return {{1. - t, t, Number(0.), Number(0.)}};
  }

  /// Adds the segment in 2-D.
  template <typename Number>
  void add_segment(const Segment2d          &segment,
                   const FaceNodes<Number>  &x_slave,
                   const PlaneNodes<Number> &slave,
                   const PlaneNodes<Number> &master,
                   const PairOptions        &options,
                   PairIntegrals<Number>    &sums)
  {
    const LineRule &rule  = line_rule(options.line_points);
    const Number    start = end_position(segment.ends[0], slave, master);
    const Number length = end_position(segment.ends[1], slave, master) - start;
    for (unsigned int g = 0; g < rule.n_points; ++g)
      {
        const Number s = start + 0.5 * (1. + rule.points[g]) * length;
        const std::array<Number, 4> N_slave = line_shape(slave, s);
        Number                      W       = 0.5 * rule.weights[g] * length;
        if (options.plane.axisymmetric)
          W *= 2. * dealii::numbers::PI *
               (N_slave[0] * x_slave[0][0] + N_slave[1] * x_slave[1][0]);
        else
          W *= options.plane.thickness;
        add_point(W, N_slave, line_shape(master, s), 2, sums);
      }
  }

  template <typename Number>
  PairIntegrals<Number> integrate_pair(const FaceNodes<Number> &slave,
                                       const FaceNodes<Number> &master,
                                       const unsigned int       n_nodes,
                                       const PairOptions       &options)
  {
    PairIntegrals<Number>        sums;
    const AuxiliaryPlane<Number> plane = auxiliary_plane(slave, n_nodes);
    if (!(value_of(plane.size) > 0.))
      return sums;
    const PlaneNodes<Number> y_slave  = projected(plane, slave, n_nodes);
    const PlaneNodes<Number> y_master = projected(plane, master, n_nodes);
    if (n_nodes == 2)
      {
        const Segment2d segment =
          find_segment(value_of(y_slave), value_of(y_master));
        sums.overlaps = segment.exists;
        if (segment.exists)
          add_segment(segment, slave, y_slave, y_master, options, sums);
        return sums;
      }
    const Segments3d found =
      find_segments(value_of(y_slave), value_of(y_master));
    const TriangleRule &rule = triangle_rule(options.triangle_points);
    sums.overlaps            = found.n_segments > 0;
    for (unsigned int i = 0; i < found.n_segments; ++i)
      add_segment(found.segments[i], y_slave, y_master, rule, sums);
    return sums;
  }
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// The part two projected faces have in common, with the origin of each vertex.
#ifndef demold_mortar_segment_3d_h
#define demold_mortar_segment_3d_h

#include "mortar/convex_cells.h"
#include "mortar/plane_vector.h"

#include <array>

namespace demold
{
  /// A vertex of a segment and where it comes from (theory B.3): it moves with
  /// a node, or with the crossing of two edges.
  struct SegmentVertex
  {
    enum class Origin
    {
      slave_node,
      master_node,
      crossing
    };
    Origin                      origin = Origin::slave_node;
    std::array<unsigned int, 2> slave{};  ///< node, or ends of the edge
    std::array<unsigned int, 2> master{}; ///< node, or ends of the edge
    PlaneVector<double>         y{};      ///< [mm]
  };

  /// A convex polygon, counter-clockwise, inside one cell of each face. Two
  /// quadrilaterals share at most eight vertices.
  struct Segment3d
  {
    static constexpr unsigned int max_vertices = 12;

    std::array<SegmentVertex, max_vertices> vertices;
    unsigned int                            n_vertices = 0;
    ConvexCell                              slave, master;
  };

  struct Segments3d
  {
    std::array<Segment3d, 4> segments;
    unsigned int             n_segments = 0;
  };

  /// Clips the cells of the slave by those of the master, in coordinates
  /// relative to the slave's centre (Sutherland & Hodgman
  /// 1974, which gives the polygon of Cyrus & Beck without sorting and merging
  /// afterwards).
  ///
  /// A vertex closer than 1e-11 of the slave's size to the line of a master
  /// edge is taken to lie on it: it stays as it is, and crossings that would
  /// coincide with it do not arise. Both masters at an edge decide alike, so
  /// the area is parted exactly, and edges that cross, cross at an angle that
  /// can be divided by. Segments of less than 1e-14 of the slave area are left
  /// out.
  Segments3d find_segments(const PlaneNodes<double> &slave,
                           const PlaneNodes<double> &master);

  /// Where a vertex is, from the positions of the nodes. Crossing (Foley form):
  ///
  ///     y = x_1 + s (x_2 - x_1),
  ///     s = (y_1 - x_1) x (y_2 - y_1) / ((x_2 - x_1) x (y_2 - y_1)).
  template <typename Number>
  PlaneVector<Number> vertex_position(const SegmentVertex      &vertex,
                                      const PlaneNodes<Number> &slave,
                                      const PlaneNodes<Number> &master)
  {
    if (vertex.origin == SegmentVertex::Origin::slave_node)
      return slave[vertex.slave[0]];
    if (vertex.origin == SegmentVertex::Origin::master_node)
      return master[vertex.master[0]];
    const PlaneVector<Number> &x1 = slave[vertex.slave[0]];
    const PlaneVector<Number> &y1 = master[vertex.master[0]];
    const PlaneVector<Number>  along_slave =
      difference(slave[vertex.slave[1]], x1);
    const PlaneVector<Number> along_master =
      difference(master[vertex.master[1]], y1);
    const Number s = cross(difference(y1, x1), along_master) /
                     cross(along_slave, along_master);
    return {{x1[0] + s * along_slave[0], x1[1] + s * along_slave[1]}};
  }
} // namespace demold

#endif

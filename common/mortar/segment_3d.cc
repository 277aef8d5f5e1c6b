// SPDX-License-Identifier: LGPL-2.1-or-later
// The part two projected faces have in common, with the origin of each vertex.
#include "mortar/segment_3d.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  namespace
  {
    using Origin = SegmentVertex::Origin;

    /// Relative to the size of the slave; see find_segments().
    constexpr double       on_line      = 1e-11;
    constexpr double       least_share  = 1e-14;
    constexpr unsigned int max_vertices = Segment3d::max_vertices;

    /// A vertex and what the edge that leaves it lies on: edge @p edge of the
    /// slave or of the master cell.
    struct ClippedVertex
    {
      SegmentVertex vertex;
      bool          edge_of_master = false;
      unsigned int  edge           = 0;
      double        share          = 0.; ///< s of a crossing
    };

    struct Polygon
    {
      std::array<ClippedVertex, max_vertices> vertices;
      unsigned int                            n = 0;

      void add(const ClippedVertex &vertex)
      {
        if (n < max_vertices)
          vertices[n++] = vertex;
      }
    };

    /// Cells, positions and tolerance of one intersection.
    struct Clipping
    {
      const ConvexCell         &slave, &master;
      const PlaneNodes<double> &y_slave, &y_master;
      double                    tolerance; ///< [mm]

      std::array<unsigned int, 2> ends(const ConvexCell  &cell,
                                       const unsigned int edge) const
      {
        return {{cell.nodes[edge], cell.nodes[(edge + 1) % cell.n_nodes]}};
      }

      /// Signed distance of a point to the line of a master edge, times the
      /// length() of the edge, > 0 inside.
      double distance(const unsigned int         edge,
                      const PlaneVector<double> &y) const
      {
        const auto                 node  = ends(master, edge);
        const PlaneVector<double> &start = y_master[node[0]];
        return cross(difference(y_master[node[1]], start),
                     difference(y, start));
      }

      double length(const unsigned int edge) const
      {
        const auto node = ends(master, edge);
        const auto e    = difference(y_master[node[1]], y_master[node[0]]);
        return std::sqrt(dot(e, e));
      }

      /// On which side of the line of a master edge the vertices are: > 0
      /// inside, 0 on the line. Of the slave only its nodes decide whether they
      /// are on the line; the crossings on its edges follow them, so that
      /// all masters agree, whatever lines they have clipped with before.
      std::array<double, max_vertices> sides(const Polygon     &polygon,
                                             const unsigned int edge) const
      {
        const double          nearness = tolerance * length(edge);
        std::array<double, 4> of_node{};
        for (unsigned int i = 0; i < slave.n_nodes; ++i)
          {
            const unsigned int node = slave.nodes[i];
            const double       d    = distance(edge, y_slave[node]);
            of_node[node]           = std::abs(d) <= nearness ? 0. : d;
          }
        std::array<double, max_vertices> d{};
        for (unsigned int i = 0; i < polygon.n; ++i)
          {
            const SegmentVertex &vertex = polygon.vertices[i].vertex;
            const double         s      = polygon.vertices[i].share;
            if (vertex.origin == Origin::slave_node)
              d[i] = of_node[vertex.slave[0]];
            else if (vertex.origin == Origin::crossing)
              d[i] = (1. - s) * of_node[vertex.slave[0]] +
                     s * of_node[vertex.slave[1]];
            else
              {
                d[i] = distance(edge, vertex.y);
                if (std::abs(d[i]) <= nearness)
                  d[i] = 0.;
              }
          }
        return d;
      }

      /// The master node in which two master edges meet. Opposite edges meet
      /// outside of the face; the vertex is clipped off by the edge between
      /// them, unless that has no length: then the nearest node stands for it.
      unsigned int common_node(const unsigned int         i,
                               const unsigned int         j,
                               const PlaneVector<double> &y) const
      {
        const auto a = ends(master, i), b = ends(master, j);
        if (a[1] == b[0])
          return a[1];
        if (b[1] == a[0])
          return a[0];
        unsigned int nearest  = a[0];
        double       smallest = -1.;
        for (const unsigned int node : {a[0], a[1]})
          {
            const auto   d        = difference(y_master[node], y);
            const double distance = dot(d, d);
            if (smallest < 0. || distance < smallest)
              {
                nearest  = node;
                smallest = distance;
              }
          }
        return nearest;
      }

      /// Where the edge from @p a to @p b meets the line of master edge
      /// @p edge.
      ClippedVertex crossing(const ClippedVertex &a,
                             const ClippedVertex &b,
                             const double         d_a,
                             const double         d_b,
                             const unsigned int   edge) const
      {
        ClippedVertex  result = a;
        SegmentVertex &vertex = result.vertex;
        if (!a.edge_of_master)
          {
            vertex.origin        = Origin::crossing;
            vertex.slave         = ends(slave, a.edge);
            vertex.master        = ends(master, edge);
            vertex.y             = vertex_position(vertex, y_slave, y_master);
            const double d_start = distance(edge, y_slave[vertex.slave[0]]);
            const double d_end   = distance(edge, y_slave[vertex.slave[1]]);
            result.share         = d_start / (d_start - d_end);
            return result;
          }
        const double t = d_a / (d_a - d_b);
        for (unsigned int c = 0; c < 2; ++c)
          vertex.y[c] += t * (b.vertex.y[c] - a.vertex.y[c]);
        vertex.origin    = Origin::master_node;
        vertex.master[0] = common_node(a.edge, edge, vertex.y);
        return result;
      }

      /// What of a polygon lies inside of master edge @p edge.
      Polygon clipped(const Polygon &polygon, const unsigned int edge) const
      {
        if (!(length(edge) > 0.))
          return polygon;
        const std::array<double, max_vertices> d   = sides(polygon, edge);
        const auto                             end = d.begin() + polygon.n;
        if (std::none_of(d.begin(), end, [](double x) { return x > 0.; }))
          return {};
        if (std::none_of(d.begin(), end, [](double x) { return x < 0.; }))
          return polygon;

        Polygon result;
        for (unsigned int i = 0; i < polygon.n; ++i)
          {
            const unsigned int   j = (i + 1) % polygon.n;
            const ClippedVertex &a = polygon.vertices[i];
            const ClippedVertex &b = polygon.vertices[j];
            if (d[i] >= 0.)
              {
                result.add(a);
                if (d[i] == 0. && d[j] < 0.)
                  leave_along(edge, result.vertices[result.n - 1]);
              }
            if ((d[i] > 0. && d[j] < 0.) || (d[i] < 0. && d[j] > 0.))
              {
                ClippedVertex vertex = crossing(a, b, d[i], d[j], edge);
                if (d[j] < 0.)
                  leave_along(edge, vertex);
                result.add(vertex);
              }
          }
        return result;
      }

      static void leave_along(const unsigned int edge, ClippedVertex &vertex)
      {
        vertex.edge_of_master = true;
        vertex.edge           = edge;
      }

      Polygon slave_cell() const
      {
        Polygon result;
        for (unsigned int i = 0; i < slave.n_nodes; ++i)
          {
            ClippedVertex vertex;
            vertex.vertex.slave[0] = slave.nodes[i];
            vertex.vertex.y        = y_slave[slave.nodes[i]];
            vertex.edge            = i;
            result.add(vertex);
          }
        return result;
      }

      Segment3d segment() const
      {
        Polygon polygon = slave_cell();
        for (unsigned int edge = 0; edge < master.n_nodes && polygon.n > 0;
             ++edge)
          polygon = clipped(polygon, edge);
        Segment3d result;
        result.slave      = slave;
        result.master     = master;
        result.n_vertices = polygon.n;
        for (unsigned int i = 0; i < polygon.n; ++i)
          {
            result.vertices[i] = polygon.vertices[i].vertex;
            if (result.vertices[i].origin == Origin::master_node)
              result.vertices[i].y = y_master[result.vertices[i].master[0]];
          }
        return result;
      }
    };

    bool boxes_meet(const PlaneNodes<double> &u, const PlaneNodes<double> &v)
    {
      for (unsigned int c = 0; c < 2; ++c)
        {
          const auto less = [c](const PlaneVector<double> &a,
                                const PlaneVector<double> &b) {
            return a[c] < b[c];
          };
          const auto bu = std::minmax_element(u.begin(), u.end(), less);
          const auto bv = std::minmax_element(v.begin(), v.end(), less);
          if (!((*bu.second)[c] > (*bv.first)[c] &&
                (*bv.second)[c] > (*bu.first)[c]))
            return false;
        }
      return true;
    }

    double area_of(const Segment3d &segment)
    {
      double area = 0.;
      for (unsigned int i = 1; i + 1 < segment.n_vertices; ++i)
        area +=
          0.5 *
          cross(difference(segment.vertices[i].y, segment.vertices[0].y),
                difference(segment.vertices[i + 1].y, segment.vertices[0].y));
      return area;
    }
  } // namespace

  Segments3d find_segments(const PlaneNodes<double> &slave,
                           const PlaneNodes<double> &master)
  {
    Segments3d result;
    if (!boxes_meet(slave, master))
      return result;
    double size = 0.;
    for (const PlaneVector<double> &y : slave)
      size = std::max(size, std::sqrt(dot(y, y)));
    const double      least        = least_share * std::abs(signed_area(slave));
    const ConvexCells slave_cells  = convex_cells(slave);
    const ConvexCells master_cells = convex_cells(master);
    for (unsigned int i = 0; i < slave_cells.n_cells; ++i)
      for (unsigned int j = 0; j < master_cells.n_cells; ++j)
        {
          const Segment3d segment = Clipping{slave_cells.cells[i],
                                             master_cells.cells[j],
                                             slave,
                                             master,
                                             on_line * size}
                                      .segment();
          if (segment.n_vertices >= 3 && area_of(segment) > least)
            result.segments[result.n_segments++] = segment;
        }
    return result;
  }
} // namespace demold

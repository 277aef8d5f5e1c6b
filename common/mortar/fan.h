// SPDX-License-Identifier: LGPL-2.1-or-later
// The centre from which a segment is divided into triangles.
#ifndef demold_mortar_fan_h
#define demold_mortar_fan_h

#include "mortar/segment_3d.h"

namespace demold
{
  /// Positions of the vertices of a segment.
  template <typename Number>
  using SegmentPositions =
    std::array<PlaneVector<Number>, Segment3d::max_vertices>;

  template <typename Number>
  SegmentPositions<Number> segment_positions(const Segment3d          &segment,
                                             const PlaneNodes<Number> &slave,
                                             const PlaneNodes<Number> &master)
  {
    SegmentPositions<Number> y;
    for (unsigned int i = 0; i < segment.n_vertices; ++i)
      y[i] = vertex_position(segment.vertices[i], slave, master);
    return y;
  }

  /// Whether the centroid of a segment is its fan's centre. That of a sliver
  /// would be lost in rounding; the mean of its vertices stands in for it.
  inline bool has_centroid(const double twice_area, const double slave_area)
  {
    constexpr double least_share = 1e-6;
    return twice_area >= 2. * least_share * slave_area;
  }

  /// Centre of the fan of triangles (centre, y_i, y_i+1) of a polygon: always
  /// its area centroid (theory B.4), which does not jump when a vertex comes
  /// or goes,
  ///
  ///     c = sum (y_i + y_i+1) (y_i x y_i+1) / (6 area).
  template <typename Number>
  PlaneVector<Number> fan_centre(const SegmentPositions<Number> &y,
                                 const unsigned int              n,
                                 const double                    slave_area)
  {
    // Seen from the mean of the vertices, to lose no digits.
    PlaneVector<Number> mean{{Number(0.), Number(0.)}};
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int c = 0; c < 2; ++c)
        mean[c] += y[i][c] / double(n);
    Number              twice_area = 0.;
    PlaneVector<Number> moment{{Number(0.), Number(0.)}};
    for (unsigned int i = 0; i < n; ++i)
      {
        const PlaneVector<Number> u    = difference(y[i], mean);
        const PlaneVector<Number> v    = difference(y[(i + 1) % n], mean);
        const Number              part = cross(u, v);
        twice_area += part;
        for (unsigned int c = 0; c < 2; ++c)
          moment[c] += part * (u[c] + v[c]);
      }
    if (!has_centroid(value_of(twice_area), slave_area))
      return mean;
    for (unsigned int c = 0; c < 2; ++c)
      mean[c] += moment[c] / (3. * twice_area);
    return mean;
  }
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// The part a slave and a master line have in common.
#ifndef demold_mortar_segment_2d_h
#define demold_mortar_segment_2d_h

#include "mortar/plane_vector.h"

#include <array>

namespace demold
{
  /// An interval along the slave line from a node to a node, in the direction
  /// of the slave.
  struct Segment2d
  {
    struct End
    {
      bool         of_master = false; ///< else of the slave
      unsigned int node      = 0;
    };
    std::array<End, 2> ends;
    bool               exists = false;
  };

  /// Clips the slave line by the master line, both given by the first
  /// coordinate of the nodes 0 and 1 along the slave line. Where two nodes
  /// coincide, the slave's counts. Less than 1e-14 of the slave is no segment.
  Segment2d find_segment(const PlaneNodes<double> &slave,
                         const PlaneNodes<double> &master);

  /// Position [mm] of an end along the slave line.
  template <typename Number>
  Number end_position(const Segment2d::End     &end,
                      const PlaneNodes<Number> &slave,
                      const PlaneNodes<Number> &master)
  {
    return end.of_master ? master[end.node][0] : slave[end.node][0];
  }
} // namespace demold

#endif

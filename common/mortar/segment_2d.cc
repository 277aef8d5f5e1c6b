// SPDX-License-Identifier: LGPL-2.1-or-later
// The part a slave and a master line have in common.
#include "mortar/segment_2d.h"

namespace demold
{
  Segment2d find_segment(const PlaneNodes<double> &slave,
                         const PlaneNodes<double> &master)
  {
    constexpr double   least_share = 1e-14;
    const unsigned int first       = master[0][0] <= master[1][0] ? 0 : 1;

    Segment2d segment;
    segment.ends[0] = {false, 0};
    segment.ends[1] = {false, 1};
    if (master[first][0] > slave[0][0])
      segment.ends[0] = {true, first};
    if (master[1 - first][0] < slave[1][0])
      segment.ends[1] = {true, 1 - first};
    segment.exists = end_position(segment.ends[1], slave, master) -
                       end_position(segment.ends[0], slave, master) >
                     least_share * (slave[1][0] - slave[0][0]);
    return segment;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Bonds of the node-to-segment term as path following sees them.
#include "contact/node_to_segment.h"
#include "contact/softening_site.h"

namespace demold
{
  using namespace dealii;

  std::vector<unsigned int> NodeToSegment::points_that_hold() const
  {
    std::vector<unsigned int> list;
    for (unsigned int p = 0; p < surfaces.n_points(); ++p)
      if (committed.holds(p))
        list.push_back(p);
    return list;
  }

  /// A deformable master turns the normal and the offset of an anchor; that
  /// part of the derivative is left out, as it is of second order.
  std::vector<SofteningSite> NodeToSegment::softening_sites() const
  {
    std::vector<SofteningSite> list;
    for (const unsigned int p : points_that_hold())
      {
        const BondHistory &bond     = committed.bond[p];
        const AnchorPlace  place    = surfaces.master().place(bond.anchor);
        SofteningSite      point    = softening_site(*law,
                                             surfaces.x(p) - place.x,
                                             place.normal,
                                             bond.state,
                                             surfaces.point(p).area,
                                             !driven.empty() && driven[p]);
        NodalUnknowns      unknowns = surfaces.unknowns(p);
        surfaces.add_master_unknowns(place.nodes, place.n_nodes, 1, unknowns);
        point.unknowns = unknowns.indices;
        for (const unsigned int entry : unknowns.entries)
          {
            point.components.push_back(entry % 3);
            point.weights.push_back(entry < 3 ? 1. : -place.N[entry / 3 - 1]);
          }
        list.push_back(point);
      }
    return list;
  }

  void NodeToSegment::drive(const std::vector<bool> &points)
  {
    const auto list = points_that_hold();
    AssertDimension(points.size(), list.size());
    driven.assign(surfaces.n_points(), false);
    for (std::size_t k = 0; k < list.size(); ++k)
      driven[list[k]] = points[k];
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the nodes of a surface are under given displacements.
#ifndef demold_contact_current_positions_h
#define demold_contact_current_positions_h

#include "contact/boundary_surface.h"
#include "weak_form/algebra.h"

namespace demold
{
  /// [mm]; @p u must be readable at the node's @p dim unknowns.
  inline dealii::Point<3> current_position(const BoundarySurface::Node &node,
                                           const Vector                &u,
                                           const unsigned int           dim)
  {
    dealii::Point<3> x = node.X;
    for (unsigned int d = 0; d < dim; ++d)
      x[d] += u(node.unknowns[d]);
    return x;
  }

  /// The same for a list of nodes.
  inline std::vector<dealii::Point<3>>
  current_positions(const std::vector<BoundarySurface::Node> &nodes,
                    const Vector                             &u,
                    const unsigned int                        dim)
  {
    std::vector<dealii::Point<3>> x;
    x.reserve(nodes.size());
    for (const auto &node : nodes)
      x.push_back(current_position(node, u, dim));
    return x;
  }
} // namespace demold

#endif

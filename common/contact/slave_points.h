// SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes of the slave surface, one point per smooth patch they belong to.
#ifndef demold_contact_slave_points_h
#define demold_contact_slave_points_h

#include "base/plane_model.h"
#include "contact/boundary_surface.h"
#include "contact/contact_surface.h"

#include <vector>

namespace demold
{
  /// Cosine of 40 degrees: facets that meet more smoothly are one surface.
  constexpr double smooth_cosine = .766;

  /// A node seen as part of one smooth patch. A node on an edge of the block
  /// is two points, one on a corner three: each has its own normal, area,
  /// contact and bond (theory B.11).
  struct SlavePoint
  {
    unsigned int              node;
    std::vector<unsigned int> facets; ///< of the patch around the node
    double                    area;   ///< [mm^2] reference, integral of N
    double                    depth;  ///< [mm] deepest penetration believed
  };

  /// Splits the surface where neighbouring facets include more than 40
  /// degrees and collects the points. The areas are integrals of the
  /// element's own shape functions over its reference faces (a quadratic line
  /// has 1/6, 4/6, 1/6 of its length) times @p plane's thickness or
  /// circumference: a uniform traction then gives the nodes the forces that a
  /// uniform stress balances. They sum to the area of the surface. That of a
  /// quadratic node on the axis of revolution is zero.
  std::vector<SlavePoint> collect_slave_points(const BoundarySurface &surface,
                                               const ContactSurface  &topology,
                                               const PlaneModel      &plane);

  /// Outward normal of a point now: mean of its facets' normals.
  dealii::Tensor<1, 3> slave_normal(const SlavePoint     &point,
                                    const ContactSurface &surface);
} // namespace demold

#endif

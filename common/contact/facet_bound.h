// SPDX-License-Identifier: LGPL-2.1-or-later
// A ball around a facet, to skip facets that a point cannot meet.
#ifndef demold_contact_facet_bound_h
#define demold_contact_facet_bound_h

#include "contact/facet.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  /// Centre, normal and size of a facet. The tests are conservative: a facet
  /// that holds the foot of a point within the limits is never skipped.
  struct FacetBound
  {
    dealii::Point<3>     centre;
    dealii::Tensor<1, 3> normal;        ///< at the centre
    double               radius   = 0.; ///< [mm] of the nodes about the centre
    bool                 is_plane = false;

    explicit FacetBound(const FacetPositions &facet)
    {
      const FacetFrame frame = facet_frame(facet, {{0., 0.}});
      centre                 = frame.x;
      normal                 = frame.normal;
      double height          = 0.;
      for (unsigned int i = 0; i < facet.n_nodes; ++i)
        {
          const dealii::Tensor<1, 3> arm = facet.x[i] - centre;
          radius                         = std::max(radius, arm.norm());
          height = std::max(height, std::abs(arm * normal));
        }
      is_plane = height <= 1e-9 * radius;
    }

    /// Can the foot of @p x lie on the facet, or within 5 % of its radius
    /// beside it, at a distance of at most @p reach [mm]?
    bool may_hold_foot(const dealii::Point<3> &x, const double reach) const
    {
      const dealii::Tensor<1, 3> d        = x - centre;
      const double               distance = d.norm();
      const double               size     = 1.05 * radius;
      if (distance > size + reach)
        return false;
      if (!is_plane)
        return true;
      const double across = d * normal;
      return std::abs(across) <= reach &&
             distance * distance - across * across <= size * size;
    }
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Averaged normal of a slave node and its derivatives.
#ifndef demold_mortar_nodal_normal_h
#define demold_mortar_nodal_normal_h

#include "contact/facet.h"

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace demold
{
  /// A face around a node, and which of its nodes the node is.
  struct FaceAround
  {
    FacetPositions face;
    unsigned int   corner;
  };

  /// Averaged normal of a node and dn/dx of the nodes of the faces around it.
  struct NodalNormal
  {
    dealii::Tensor<1, 3> n; ///< outward unit vector, 0 where there is none
    /// [1/mm] per face around and node I of it: dn_i/dx_I,j. Nodes that belong
    /// to several faces add up.
    std::vector<std::array<dealii::Tensor<2, 3>, 4>> dn;
  };

  /// n = sum n_e / |sum n_e| over the unit normals of the faces at the node
  /// (theory B.1). @p around holds the faces of one smooth patch (theory B.11)
  /// only. Faces without a normal there do not count; if none counts, or they
  /// cancel, n and its derivatives are zero.
  NodalNormal nodal_normal(const std::vector<FaceAround> &around);

  /// n alone.
  dealii::Tensor<1, 3>
  nodal_normal_value(const std::vector<FaceAround> &around);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows of the mortar operators D and M for the points that need them.
#ifndef demold_mortar_mortar_operator_h
#define demold_mortar_mortar_operator_h

#include "mortar/face_rows.h"
#include "mortar/mortar_surfaces.h"
#include "mortar/nodal_row.h"
#include "mortar/pair_integrals.h"

#include <vector>

namespace demold
{
  /// What a point wants to know of its row.
  enum class RowDemand
  {
    nothing,
    values,
    derivatives
  };

  /// Averaged normal of a point and its derivatives by the nodes around.
  struct PointNormal
  {
    dealii::Tensor<1, 3>              n;
    std::vector<unsigned int>         nodes;
    std::vector<dealii::Tensor<2, 3>> dn; ///< dn/dx_l [1/mm]

    void add(const unsigned int node, const dealii::Tensor<2, 3> &change)
    {
      for (unsigned int l = 0; l < nodes.size(); ++l)
        if (nodes[l] == node)
          {
            dn[l] += change;
            return;
          }
      nodes.push_back(node);
      dn.push_back(change);
    }
  };

  /// Integrates the segments between slave faces and opposite master facets
  /// and sums them up by points (theory B.6, B.7).
  class MortarOperator
  {
  public:
    /// @p surfaces must live as long as this. With @p dual the multipliers
    /// are biorthogonal to the displacements, so that D is diagonal.
    MortarOperator(const MortarSurfaces &surfaces,
                   const PairOptions    &options,
                   const bool            dual);

    /// Rows of the own points, in their order; @p demand has an entry each.
    std::vector<NodalRow> rows(const std::vector<RowDemand> &demand) const;

    /// Normals of the own points now (theory B.1).
    std::vector<PointNormal> normals() const;

  private:
    FaceRows integrate(const unsigned int face,
                       const bool         with_derivatives) const;

    /// Own numbers of the points of a face, invalid where another rank's.
    std::vector<unsigned int> own_points_of(const unsigned int face) const;

    static RowDemand own_demand(const std::vector<RowDemand> &demand,
                                const unsigned int            own);

    const MortarSurfaces     &surfaces;
    const PairOptions         options;
    const bool                dual;
    std::vector<unsigned int> own_of_point; ///< own number of a point
  };
} // namespace demold

#endif

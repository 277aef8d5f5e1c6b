// SPDX-License-Identifier: LGPL-2.1-or-later
// The gap vector of a multiplier point and how it depends on the nodes.
#ifndef demold_mortar_point_gap_h
#define demold_mortar_point_gap_h

#include "mortar/mortar_operator.h"
#include "mortar/mortar_surfaces.h"
#include "mortar/nodal_row.h"

#include <deal.II/base/tensor.h>

#include <vector>

namespace demold
{
  /// Gap per area and normal, with derivatives by the nodes that have
  /// unknowns.
  struct PointGap
  {
    dealii::Tensor<1, 3>              gap;       ///< [mm]
    double                            area = 0.; ///< [mm^2]
    std::vector<unsigned int>         nodes;
    std::vector<dealii::Tensor<2, 3>> dgap;    ///< dgap/dx_l [-], all told
    std::vector<dealii::Tensor<2, 3>> dnormal; ///< dn/dx_l [1/mm]
    std::vector<dealii::Tensor<1, 3>> darea;   ///< [mm]

    /// Position of a node in the lists, appended where it is new.
    unsigned int position(const unsigned int node);
  };

  /// sum_k w_k x_k [mm^3] now.
  dealii::Tensor<1, 3> weighted_gap(const MortarSurfaces &surfaces,
                                    const NodalRow       &row);

  /// Where the slave side of a row is [mm]: its weighted mean.
  dealii::Point<3> slave_point(const MortarSurfaces &surfaces,
                               const NodalRow       &row);

  /// The slave side of a row alone, with its area.
  NodalRow slave_side(const MortarSurfaces &surfaces, const NodalRow &row);

  /// Gap of a bond: (offset + sum_k w_k x_k) / A with fixed weights (theory
  /// B4). @p offset [mm^3] is what does not depend on unknowns.
  PointGap frozen_point_gap(const MortarSurfaces       &surfaces,
                            const NodalRow             &row,
                            const dealii::Tensor<1, 3> &offset,
                            const PointNormal          &normal);

  /// Gap of a point without a bond: g_N n from the current row (theory B2) and
  /// the slip since t_n (theory B3), which needs the row of t_n; no slip where
  /// @p old_row is empty.
  PointGap current_point_gap(const MortarSurfaces &surfaces,
                             const NodalRow       &row,
                             const NodalRow       &old_row,
                             const PointNormal    &normal);
} // namespace demold

#endif

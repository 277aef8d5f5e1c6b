// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of the mortar integrals of a pair by the positions of its nodes.
#ifndef demold_mortar_pair_gradients_h
#define demold_mortar_pair_gradients_h

#include "mortar/pair_integrals.h"

#include <array>

namespace demold
{
  /// Derivatives by q = (slave node 0 x, y, z, slave node 1 x, ..., master node
  /// 0 x, ...): 24 entries in 3-D; 12 in 2-D, those along z zero.
  using PairGradient = std::array<double, 24>;

  /// Integrals of a pair with their exact derivatives.
  struct PairGradients
  {
    PairIntegrals<double>                      value;
    std::array<std::array<PairGradient, 4>, 4> dD{};    ///< [mm]
    std::array<std::array<PairGradient, 4>, 4> dM{};    ///< [mm]
    PairGradient                               darea{}; ///< [mm]
  };

  /// Whose positions a pair is derived by. The master of a rigid mould has no
  /// unknowns; its entries then stay zero.
  enum class DerivedBy
  {
    slave_and_master,
    slave
  };

  /// integrate_pair() and its derivatives (theory B.10), by hand. Everything
  /// after the projection happens in the auxiliary plane, where D, M and the
  /// area depend on two coordinates per node alone:
  ///
  ///     3-D nodes -> coordinates in the plane -> vertices of the segment
  ///     -> centroid -> Gauss point, determinant -> N_A, N_C -> D, M.
  ///
  /// Where the shape of a segment changes, the derivative is that of one side.
  PairGradients pair_gradients(const FacetPositions &slave,
                               const FacetPositions &master,
                               const PairOptions    &options,
                               const DerivedBy       derived_by);
} // namespace demold

#endif

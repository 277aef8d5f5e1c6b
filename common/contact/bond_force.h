// SPDX-License-Identifier: LGPL-2.1-or-later
// The bond of one slave point to its anchor: response of the law, nodal forces.
#ifndef demold_contact_bond_force_h
#define demold_contact_bond_force_h

#include "adhesion/adhesion_law.h"
#include "contact/master.h"
#include "contact/newton_stage.h"
#include "contact/point_history.h"

#include <array>

namespace demold
{
  /// Response of the bond @p old at the gap vector @p gap [mm] from its anchor
  /// with master normal @p normal. When @p stage says so it keeps @p last, its
  /// status in the last assembly, unless the gap contradicts.
  AdhesionResponse bond_response(const AdhesionLaw          &law,
                                 const dealii::Tensor<1, 3> &gap,
                                 const dealii::Tensor<1, 3> &normal,
                                 const BondHistory          &old,
                                 const AdhesionStatus        last,
                                 const NewtonStage           stage);

  /// Forces [MPa] and tangent [MPa/mm] of a bond with
  /// q = (x_s, anchor nodes), three entries per node.
  struct BondForce
  {
    std::array<double, 15>                 R{};
    std::array<std::array<double, 15>, 15> K{};
  };

  /// Spreads the traction over the nodes of @p place: the weights are
  /// (1, -N_1 ... -N_n), dg = dx_s - sum N_I dx_I.
  BondForce bond_force(const AdhesionResponse &response,
                       const AnchorPlace      &place,
                       const bool              with_tangent);
} // namespace demold

#endif

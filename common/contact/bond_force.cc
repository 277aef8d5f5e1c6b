// SPDX-License-Identifier: LGPL-2.1-or-later
// The bond of one slave point to its anchor: response of the law, nodal forces.
#include "contact/bond_force.h"

#include <deal.II/base/symmetric_tensor.h>

#include <optional>

namespace demold
{
  using namespace dealii;

  AdhesionResponse bond_response(const AdhesionLaw   &law,
                                 const Tensor<1, 3>  &gap,
                                 const Tensor<1, 3>  &normal,
                                 const BondHistory   &old,
                                 const AdhesionStatus last,
                                 const NewtonStage    stage)
  {
    std::optional<AdhesionStatus> forced;
    if (stage.keeps_bond_states() && old.status != AdhesionStatus::separated)
      forced = last;
    AdhesionResponse response = law.evaluate(gap, normal, old.state, forced);
    if (!response.consistent) // freezing must not end in a wrong state
      response = law.evaluate(gap, normal, old.state);
    if (stage.lets_bonds_jump() &&
        response.status == AdhesionStatus::decohesion)
      {
        response.dt_dg = NewtonStage::jump_stiffness *
                         (response.traction * gap) / gap.norm_square() *
                         unit_symmetric_tensor<3>();
        response.dt_dn = Tensor<2, 3>();
      }
    return response;
  }

  BondForce bond_force(const AdhesionResponse &response,
                       const AnchorPlace      &place,
                       const bool              with_tangent)
  {
    BondForce  force;
    const auto weight = [&place](const unsigned int a) {
      return a == 0 ? 1. : -place.N[a - 1];
    };
    for (unsigned int a = 0; a <= place.n_nodes; ++a)
      for (unsigned int i = 0; i < 3; ++i)
        force.R[3 * a + i] = weight(a) * response.traction[i];
    if (!with_tangent)
      return force;
    for (unsigned int a = 0; a <= place.n_nodes; ++a)
      for (unsigned int b = 0; b <= place.n_nodes; ++b)
        {
          Tensor<2, 3> dt = weight(b) * response.dt_dg;
          if (b > 0)
            dt += response.dt_dn * place.dnormal[b - 1] -
                  response.dt_dg * place.doffset[b - 1];
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              force.K[3 * a + i][3 * b + j] = weight(a) * dt[i][j];
        }
    return force;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// A step in time of a point whose branches remember its whole C.
#ifndef demold_material_branch_step_h
#define demold_material_branch_step_h

#include "material/response_sums.h"

namespace demold
{
  /// What the variants V2 to V4 see of a point (theory A.2). An isochoric
  /// branch has its own, ViscousStep.
  struct BranchStep
  {
    const Deformation &x;     ///< at t_n+1
    Six                C_old; ///< at t_n, from the history
    Six                K_old; ///< its inverse
    double             dt;    ///< [s]
    bool               with_tangent;
    bool               with_energies;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// A Maxwell branch of linear evolution: C_i runs after C, volume included.
#ifndef demold_material_linear_branch_h
#define demold_material_linear_branch_h

#include "material/branch_step.h"

namespace demold
{
  /// Variant V2 (theory A.2): with b_e = F C_i^-1 F^T
  ///   W = mu/2 (tr b_e - 3 - ln det b_e),   S = mu (C_i^-1 - C^-1),
  ///   dC_i/dt = (C - C_i)/tau,              D = mu/(2 tau) |b_e - 1|^2 >= 0.
  /// The update is exact where C is linear in time over the step, hence of
  /// second order on a smooth path. Unlike the isochoric branch it answers a
  /// change of volume as well, with a bulk modulus of 2/3 mu while it is fast.
  /// The dissipation of a step is of second order too; where one step of a
  /// length near tau relaxes a shear of 1 it is 9 % too large, of 2 37 %.
  struct LinearBranch
  {
    double modulus;         ///< mu = E/3 [MPa]
    double relaxation_time; ///< tau [s]

    /// Adds stress and, on demand, algorithmic tangent, stored energy and
    /// dissipation over the step. @p Ci_old: six doubles of C_i at t_n;
    /// @p Ci_new: at t_n+1, computed here.
    void add(const BranchStep &step,
             const double     *Ci_old,
             double           *Ci_new,
             ResponseSums     &sums) const;
  };
} // namespace demold

#endif

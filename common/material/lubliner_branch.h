// SPDX-License-Identifier: LGPL-2.1-or-later
// A Maxwell branch of Lubliner's flow rule: C_i^-1 runs after C^-1.
#ifndef demold_material_lubliner_branch_h
#define demold_material_lubliner_branch_h

#include "material/branch_step.h"

namespace demold
{
  /// Variant V3 (theory A.2): energy and stress of LinearBranch, but
  ///   d(C_i^-1)/dt = (C^-1 - C_i^-1)/tau,
  ///   D = mu/(2 tau) tr[(b_e - 1)^2 b_e^-1] >= 0.
  /// In space this is the upper-convected Maxwell fluid with
  /// tau = mu (b_e - 1). The update is exact where C^-1 is linear in time over
  /// the step, hence of second order on a smooth path. It answers a change of
  /// volume too, as LinearBranch does. The dissipation of one step of a length
  /// near tau that relaxes a shear of 1 is 3 % too large, of 2 11 %.
  struct LublinerBranch
  {
    double modulus;         ///< mu = E/3 [MPa]
    double relaxation_time; ///< tau [s]

    /// Adds stress and, on demand, algorithmic tangent, stored energy and
    /// dissipation over the step. @p B_old: six doubles of the inverse C_i^-1
    /// at t_n; @p B_new: at t_n+1, computed here.
    void add(const BranchStep &step,
             const double     *B_old,
             double           *B_new,
             ResponseSums     &sums) const;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Maxwell branches as the fading memory of the isochoric elastic stress.
#ifndef demold_material_convolution_branches_h
#define demold_material_convolution_branches_h

#include "material/branch_step.h"
#include "material/maxwell_branch.h"

#include <vector>

namespace demold
{
  /// Variant V4 (theory A.2; Simo 1987): the overstress of branch j is
  ///   H_j(t) = integral of exp(-(t-s)/tau_j) mu_j d S_iso(s),
  /// S_iso being the stress of W_iso = (1-r)/2 (I1bar-3) + r/2 (I2bar-3), the
  /// isochoric part of the elastic law per shear modulus, so that mu_j S_iso
  /// is g_j times its isochoric stress with g_j = mu_j/G. Update
  ///   H_n+1 = e H_n + q mu (S_iso,n+1 - S_iso,n),  e = exp(-h), q = (1-e)/h,
  /// exact where S_iso is linear in time over the step, hence of second order
  /// on a smooth path; theory A.2 has exp(-h/2), the midpoint value of the
  /// same mean, which loses the steady flow of long steps.
  ///
  /// The cheapest of the variants, and it claims no dissipation inequality:
  /// no energy of the state (C, H) is known whose rate stays below the power.
  /// So nothing is added to the stored energy, and what is added to the
  /// dissipated one is all the work done on the branches over the step, by the
  /// trapezoidal rule: less than 0 while they give it back.
  struct ConvolutionBranches
  {
    double share_of_I2; ///< r, between 0 and 1 [-]

    /// Adds all @p branches. @p H_old: six doubles [MPa] for each at t_n;
    /// @p H_new: at t_n+1, computed here.
    void add(const BranchStep                 &step,
             const std::vector<MaxwellBranch> &branches,
             const double                     *H_old,
             double                           *H_new,
             ResponseSums                     &sums) const;
  };
} // namespace demold

#endif

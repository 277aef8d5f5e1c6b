// SPDX-License-Identifier: LGPL-2.1-or-later
// Gap, tangent and status of one row of the point law, before its history.
#ifndef demold_adhesion_resolvent_branch_h
#define demold_adhesion_resolvent_branch_h

#include "adhesion/radial_gap.h"
#include "adhesion/traction_resolvent.h"

namespace demold
{
  /// One row of the table of theory C.4. Of the response only gaps,
  /// derivatives, status and utilisation are set.
  struct ResolventBranch
  {
    ResolventResponse response;
    /// Effective gap [mm] on the softening branch, not cut at kappa or rupture.
    double effective = 0.;
    /// Its derivatives by the augmented traction [mm/MPa].
    double               deffective_dN = 0.;
    dealii::Tensor<1, 3> deffective_dT;
  };

  /// lambda_hat_N > 0: no pressure.
  ResolventBranch open_branch(const TractionResolvent          &law,
                              const AugmentedTraction          &traction,
                              const ResolventState             &old,
                              const std::optional<ForcedBranch> forced);

  /// lambda_hat_N <= 0: pressure, g_N = 0. @p coefficient is mu omega [-], 0
  /// for a point that closes in this increment.
  ResolventBranch pressed_branch(const TractionResolvent          &law,
                                 const AugmentedTraction          &traction,
                                 const ResolventState             &old,
                                 const double                      coefficient,
                                 const std::optional<ForcedBranch> forced);
} // namespace demold

#endif

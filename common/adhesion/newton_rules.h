// SPDX-License-Identifier: LGPL-2.1-or-later
// Which branches a point may take from one Newton iteration to the next.
#ifndef demold_adhesion_newton_rules_h
#define demold_adhesion_newton_rules_h

#include "adhesion/traction_resolvent.h"

namespace demold
{
  /// Where a point was in the last iteration; the default is right for the
  /// first one.
  struct NewtonMemory
  {
    unsigned int         iteration = 0; ///< of the coming evaluation
    AdhesionStatus       bond      = AdhesionStatus::adhering;
    ContactStatus        contact   = ContactStatus::closed;
    dealii::Tensor<1, 3> slide; ///< unit, 0 unless it slid

    /// For the iteration after the one that gave @p response.
    NewtonMemory after(const ResolventResponse &response) const;
  };

  /// Newton rules of theory C.4, as the branch to force upon @p free, the
  /// response without any rule.
  ///  start:   in iteration 0 a sliding point sticks;
  ///  no-skip: a bond that did not soften in the last iteration may soften in
  ///           this one but not separate;
  ///  flip:    a slide that turns by more than 90 degrees stops once.
  std::optional<ForcedBranch> newton_rule(const ResolventResponse &free,
                                          const NewtonMemory      &last);

  /// TractionResolvent::evaluate() under these rules.
  ResolventResponse evaluate_by_rules(const TractionResolvent &law,
                                      const AugmentedTraction &traction,
                                      const ResolventState    &old,
                                      const NewtonMemory      &last);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Explicit dynamics: very many short steps, none of which solves a system.
#ifndef demold_solution_explicit_dynamics_h
#define demold_solution_explicit_dynamics_h

#include "solution/strategy.h"

#include <functional>

namespace demold
{
  class CentralDifferences;
  class WeakForm;
  struct ExplicitParameters;

  /// What explicit dynamics works with, besides the weak form.
  struct ExplicitTools
  {
    CentralDifferences       &motion; ///< a term already
    const ExplicitParameters &parameters;
    double                   &seconds_assembly; ///< added to
    double energy_factor; ///< whole body over model, in words
    std::function<void(const std::string &)> note; ///< on the console
  };

  /// Integrates @p weak_form to @p end_time by central differences. The step
  /// is a share of the critical one, which is found anew from time to time and
  /// where points have changed their state. Records come after every interval
  /// of `increments.largest`; steps are equal within one. Gives up where an
  /// element turns inside out or energy comes from nowhere.
  StrategyResult run_explicit_dynamics(WeakForm                  &weak_form,
                                       const ExplicitTools       &tools,
                                       const IncrementParameters &increments,
                                       const double               end_time,
                                       const OnAccept            &on_accept);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// The cheapest strategy that is stable at the moment.
#ifndef demold_solution_automatic_h
#define demold_solution_automatic_h

#include "solution/strategy.h"

namespace demold
{
  class Inertia;
  class WeakForm;
  struct TimeIntegrator;

  /// What the controller works with. `note` is told what is chosen and why.
  struct AutomaticTools
  {
    NonlinearSolver      &newton;
    Inertia              &inertia; ///< in the weak form
    const TimeIntegrator &integrator;
    double energy_factor = 1.; ///< whole body over model, in events
    std::function<void(const std::string &)> note = [](const std::string &) {};
  };

  /// Quasi-static as long as increments are found whose energy the ledger
  /// explains; dynamic where not, because something jumps; quasi-static again
  /// when inertia forces have gone. Whoever comes back too early stays dynamic
  /// twice as long the next time.
  StrategyResult run_automatic(WeakForm                  &weak_form,
                               const AutomaticTools      &tools,
                               const IncrementParameters &increments,
                               const double               end_time,
                               const OnAccept            &on_accept);
} // namespace demold

#endif

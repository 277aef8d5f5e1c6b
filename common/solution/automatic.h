// SPDX-License-Identifier: LGPL-2.1-or-later
// The cheapest strategy that is stable at the moment.
#ifndef demold_solution_automatic_h
#define demold_solution_automatic_h

#include "solution/path_following.h"

namespace demold
{
  class Inertia;
  class WeakForm;
  struct TimeIntegrator;

  /// What the controller works with; `path.note` is told what is chosen and
  /// why.
  struct AutomaticTools
  {
    PathTools             path;
    Inertia              &inertia; ///< in the weak form
    const TimeIntegrator &integrator;
    double energy_factor = 1.;   ///< whole body over model, in events
    bool   detours       = true; ///< along the path past small jumps?
  };

  /// Quasi-static as long as increments are found whose energy the ledger
  /// explains. Where not, because something jumps: along the path past the
  /// jump, as long as all such jumps together release no more than the ledger
  /// of quasi-statics may leave open in one increment; else dynamic, and
  /// quasi-static again when inertia forces have gone. Whoever comes back too
  /// early stays dynamic twice as long the next time, and after a detour in
  /// vain the next jumps are left to dynamics, every time more.
  StrategyResult run_automatic(WeakForm                  &weak_form,
                               const AutomaticTools      &tools,
                               const IncrementParameters &increments,
                               const double               end_time,
                               const OnAccept            &on_accept);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Equilibrium increment by increment.
#ifndef demold_solution_quasi_static_h
#define demold_solution_quasi_static_h

#include "solution/strategy.h"

namespace demold
{
  class WeakForm;
  struct Books;
  struct IncrementHooks;

  /// Judges quasi-static increments by the terms and by the ledger, but takes
  /// those up to @p jump [s] as they are: what still happens in one of them is
  /// a jump. The arguments must live as long as the hooks.
  IncrementHooks quasi_static_hooks(WeakForm    &weak_form,
                                    Books       &books,
                                    const double jump);

  /// Follows the equilibrium of @p weak_form to @p end_time with adaptive
  /// increments, as long as the terms find them accurate. Where softening
  /// outruns the elastic unloading, the next equilibrium is far away: the step
  /// is then a jump (theory D.1).
  StrategyResult run_quasi_static(WeakForm                  &weak_form,
                                  NonlinearSolver           &newton,
                                  const IncrementParameters &increments,
                                  const double               end_time,
                                  const OnAccept            &on_accept);
} // namespace demold

#endif

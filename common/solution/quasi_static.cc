// SPDX-License-Identifier: LGPL-2.1-or-later
// Equilibrium increment by increment.
#include "solution/quasi_static.h"

#include "solution/adaptive_increments.h"
#include "weak_form/weak_form.h"

namespace demold
{
  namespace
  {
    /// Increments shorter than this share of the largest one are not cut for
    /// accuracy any more: what still happens in one of them is a jump.
    constexpr double jump_resolution = 1e-3;
  } // namespace

  StrategyResult run_quasi_static(WeakForm &                 weak_form,
                                  NonlinearSolver &                   newton,
                                  const IncrementParameters &increments,
                                  const double               end_time,
                                  const OnAccept &           on_accept)
  {
    IncrementHooks hooks;
    hooks.name = "quasi-static";
    hooks.judge = [&](const double dt) {
      IncrementVerdict verdict = judge_by_terms(weak_form);
      if (dt <= jump_resolution * increments.largest)
        verdict.accept = true;
      return verdict;
    };
    weak_form.set_bulk_weight(1.);
    return run_increments(
      weak_form, newton, increments, end_time, hooks, on_accept);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Increments of time that are cut, grown and rolled back.
#ifndef demold_solution_adaptive_increments_h
#define demold_solution_adaptive_increments_h

#include "solution/strategy.h"

namespace demold
{
  class WeakForm;

  /// What a strategy says about an increment whose Newton iteration has
  /// converged: is it accurate enough, and how long may the next one be?
  struct IncrementVerdict
  {
    bool        accept = true;
    double      factor = 1e300; ///< on dt, an upper bound
    std::string reason;         ///< of a rejection
  };

  /// Hooks by which strategies differ.
  struct IncrementHooks
  {
    std::string                                name;
    std::function<void(double dt)>             before = [](double) {};
    std::function<IncrementVerdict(double dt)> judge  = [](double) {
      return IncrementVerdict();
    };
    std::function<void()> after_accept = [] {};

    /// Start Newton from an extrapolation of the last increment.
    bool extrapolate = true;
  };

  /// Asks every term for the error of the converged trial: accept if none is
  /// above 1, next dt by clip(0.9 min(ratio^(-1/order))) (theory D.4).
  IncrementVerdict judge_by_terms(const WeakForm &weak_form);

  /// Goes from the accepted time to @p end_time. A failed or inaccurate
  /// increment is rolled back and repeated with a shorter one; below
  /// `smallest` the run gives up with the reason and the residual history.
  StrategyResult run_increments(WeakForm                  &weak_form,
                                NonlinearSolver           &newton,
                                const IncrementParameters &parameters,
                                const double               end_time,
                                const IncrementHooks      &hooks,
                                const OnAccept            &on_accept);
} // namespace demold

#endif

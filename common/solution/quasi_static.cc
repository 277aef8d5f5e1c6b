// SPDX-License-Identifier: LGPL-2.1-or-later
// Equilibrium increment by increment.
#include "solution/quasi_static.h"

#include "solution/adaptive_increments.h"
#include "solution/books.h"
#include "weak_form/weak_form.h"

#include <algorithm>

namespace demold
{
  namespace
  {
    /// Increments shorter than this share of the largest one are not cut for
    /// accuracy any more: what still happens in one of them is a jump.
    constexpr double jump_resolution = 1e-3;
  } // namespace

  IncrementHooks quasi_static_hooks(WeakForm    &weak_form,
                                    Books       &books,
                                    const double jump)
  {
    IncrementHooks hooks;
    hooks.name  = "quasi-static";
    hooks.judge = [&weak_form, &books, jump](const double dt) {
      IncrementVerdict verdict    = judge_by_terms(weak_form);
      const bool       bonds_give = verdict.factor < 1e299;
      books.trial                 = weak_form.energies();
      if (bonds_give && books.are_open())
        {
          verdict.accept = false;
          verdict.factor = std::min(verdict.factor, .5);
          verdict.reason = "the ledger does not explain " +
                           std::to_string(100. * books.unexplained_share()) +
                           " % of its largest entry";
        }
      if (dt <= jump)
        verdict.accept = true;
      return verdict;
    };
    hooks.after_accept = [&books] { books.accept(); };
    return hooks;
  }

  StrategyResult run_quasi_static(WeakForm                  &weak_form,
                                  NonlinearSolver           &newton,
                                  const IncrementParameters &increments,
                                  const double               end_time,
                                  const OnAccept            &on_accept)
  {
    Books books(weak_form);
    weak_form.set_bulk_weight(1.);
    StrategyResult result =
      run_increments(weak_form,
                     newton,
                     increments,
                     end_time,
                     quasi_static_hooks(weak_form,
                                        books,
                                        jump_resolution * increments.largest),
                     on_accept);
    if (result.gave_up)
      result.reason += ". There may be no equilibrium near the last one: try "
                       "Solution/strategy = automatic, or arc length";
    return result;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Equilibrium increment by increment.
#include "solution/quasi_static.h"

#include "solution/adaptive_increments.h"
#include "weak_form/weak_form.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  namespace
  {
    /// Increments shorter than this share of the largest one are not cut for
    /// accuracy any more: what still happens in one of them is a jump.
    constexpr double jump_resolution = 1e-3;

    /// While bonds give, an increment may leave this share of the largest
    /// ledger entry unexplained: external work is known by the trapezoidal
    /// rule only, and forces have kinks.
    constexpr double tolerated_gap = 2e-3;
  } // namespace

  Books::Books(const WeakForm &weak_form)
    : accepted(weak_form.energies())
    , trial(accepted)
  {}

  double Books::unexplained_share() const
  {
    double largest = largest_entry;
    for (const double entry : trial.as_array())
      largest = std::max(largest, std::abs(entry));
    return std::abs(trial.gap() - accepted.gap()) / std::max(largest, 1e-300);
  }

  void Books::accept()
  {
    accepted = trial;
    for (const double entry : trial.as_array())
      largest_entry = std::max(largest_entry, std::abs(entry));
  }

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
      const double share          = books.unexplained_share();
      if (bonds_give && share > tolerated_gap)
        {
          verdict.accept = false;
          verdict.factor = std::min(verdict.factor, .5);
          verdict.reason = "the ledger does not explain " +
                           std::to_string(100. * share) +
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
                       "Solution/strategy = automatic";
    return result;
  }
} // namespace demold

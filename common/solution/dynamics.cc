// SPDX-License-Identifier: LGPL-2.1-or-later
// Implicit dynamics with increments as long as accuracy allows.
#include "solution/dynamics.h"

#include "solution/inertia.h"
#include "solution/adaptive_increments.h"
#include "weak_form/weak_form.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  StrategyResult run_dynamics(WeakForm &                 weak_form,
                              Newton &                   newton,
                              Inertia &                  inertia,
                              const TimeIntegrator &     integrator,
                              const IncrementParameters &increments,
                              const double               end_time,
                              const OnAccept &           on_accept)
  {
    IncrementHooks hooks;
    hooks.name = "dynamics";
    weak_form.set_bulk_weight(1. - integrator.alpha_f());
    hooks.judge = [&] {
      inertia.account_damping(weak_form);
      IncrementVerdict verdict;
      for (const auto &term : weak_form.term_list())
        {
          const IncrementError error = term->increment_error();
          verdict.accept             = verdict.accept && error.ratio <= 1.;
          // Second half of the tolerance is the margin between the error
          // aimed at and the one still accepted.
          if (error.ratio > 0.)
            verdict.factor =
              std::min(verdict.factor,
                       .9 * std::pow(error.order > 1. ? .5 / error.ratio :
                                                        1. / error.ratio,
                                     1. / error.order));
          if (error.ratio > 1.)
            verdict.reason = term->name() + " error is " +
                             std::to_string(error.ratio) +
                             " times what is tolerated";
        }
      return verdict;
    };
    hooks.after_accept = [&] {
      for (const auto &term : weak_form.term_list())
        inertia.close(term->closed_points());
    };
    const StrategyResult result = run_increments(
      weak_form, newton, increments, end_time, hooks, on_accept);
    weak_form.set_bulk_weight(1.);
    return result;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Implicit dynamics with increments as long as accuracy allows.
#include "solution/dynamics.h"

#include "solution/adaptive_increments.h"
#include "solution/inertia.h"
#include "weak_form/weak_form.h"

namespace demold
{
  IncrementHooks dynamic_hooks(WeakForm &weak_form, Inertia &inertia)
  {
    IncrementHooks hooks;
    hooks.name  = "dynamics";
    hooks.judge = [&](double) {
      inertia.account_damping(weak_form);
      return judge_by_terms(weak_form);
    };
    hooks.after_accept = [&] {
      for (const auto &term : weak_form.term_list())
        inertia.close(term->closed_points());
    };
    return hooks;
  }

  StrategyResult run_dynamics(WeakForm                  &weak_form,
                              NonlinearSolver           &newton,
                              Inertia                   &inertia,
                              const TimeIntegrator      &integrator,
                              const IncrementParameters &increments,
                              const double               end_time,
                              const OnAccept            &on_accept)
  {
    weak_form.set_bulk_weight(1. - integrator.alpha_f());
    const StrategyResult result =
      run_increments(weak_form,
                     newton,
                     increments,
                     end_time,
                     dynamic_hooks(weak_form, inertia),
                     on_accept);
    weak_form.set_bulk_weight(1.);
    return result;
  }
} // namespace demold

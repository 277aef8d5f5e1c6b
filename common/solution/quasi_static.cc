// SPDX-License-Identifier: LGPL-2.1-or-later
// Equilibrium increment by increment.
#include "solution/quasi_static.h"

#include "solution/adaptive_increments.h"
#include "weak_form/weak_form.h"

namespace demold
{
  StrategyResult run_quasi_static(WeakForm &                 weak_form,
                                  Newton &                   newton,
                                  const IncrementParameters &increments,
                                  const double               end_time,
                                  const OnAccept &           on_accept)
  {
    IncrementHooks hooks;
    hooks.name = "quasi-static";
    weak_form.set_bulk_weight(1.);
    return run_increments(
      weak_form, newton, increments, end_time, hooks, on_accept);
  }
} // namespace demold

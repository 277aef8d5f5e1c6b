// SPDX-License-Identifier: LGPL-2.1-or-later
// Implicit dynamics with increments as long as accuracy allows.
#ifndef demold_solution_dynamics_h
#define demold_solution_dynamics_h

#include "solution/strategy.h"

namespace demold
{
  class Inertia;
  class WeakForm;
  struct IncrementHooks;
  struct TimeIntegrator;

  /// Judges increments of a dynamic run. The arguments must live as long.
  IncrementHooks dynamic_hooks(WeakForm &weak_form, Inertia &inertia);

  /// Adds @p inertia to @p weak_form and integrates to @p end_time. A step is
  /// accepted if no term finds its error too large, and the next one follows
  /// dt * clip(0.9 min(ratio^(-1/order)), 0.1, 1.5) (theory D.4). Bulk forces
  /// are blended, interface forces enter at t_{n+1}; after each step closed
  /// points get the normal velocity of the mould.
  StrategyResult run_dynamics(WeakForm                  &weak_form,
                              NonlinearSolver           &newton,
                              Inertia                   &inertia,
                              const TimeIntegrator      &integrator,
                              const IncrementParameters &increments,
                              const double               end_time,
                              const OnAccept            &on_accept);
} // namespace demold

#endif

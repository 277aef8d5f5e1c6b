// SPDX-License-Identifier: LGPL-2.1-or-later
// From the entry Solution/strategy to something that solves the scene.
#ifndef demold_scene_scene_strategy_h
#define demold_scene_scene_strategy_h

#include "scene/scene_system.h"
#include "solution/strategy.h"

#include <functional>

namespace demold
{
  /// Follows a scene to its end.
  using Strategy = std::function<StrategyResult(const OnAccept &)>;

  /// What every strategy works on.
  struct StrategyTools
  {
    WeakForm                                &weak_form;
    NonlinearSolver                         &newton;
    LinearSolver                            &linear_solver;
    double                                   end_time; ///< [s]
    std::function<void(const std::string &)> note;     ///< on the console
  };

  /// The strategy that @p parameters name, but for dynamics. Where increments
  /// stand is kept in @p state. What the arguments refer to must live as long
  /// as the result.
  Strategy make_strategy(const SceneParameters &parameters,
                         const StrategyTools   &tools,
                         IncrementState        &state);

  /// The same for a body, dynamics too. The terms it needs, inertia for
  /// dynamics, are in the weak form when this returns, so that a checkpoint
  /// can be read before the strategy is called.
  template <int dim>
  Strategy make_strategy(const Scene<dim>      &scene,
                         const SceneParameters &parameters,
                         SceneSystem<dim>      &system,
                         const StrategyTools   &tools,
                         IncrementState        &state);
} // namespace demold

#endif

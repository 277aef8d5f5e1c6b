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

  /// The strategy that @p parameters name. The terms it needs, inertia for
  /// dynamics, are in the weak form when this returns, so that a checkpoint
  /// can be read before the strategy is called. Where increments stand is kept
  /// in @p state. All arguments must live as long as the result.
  template <int dim>
  Strategy make_strategy(const Scene<dim>      &scene,
                         const SceneParameters &parameters,
                         SceneSystem<dim>      &system,
                         NonlinearSolver       &newton,
                         IncrementState        &state);
} // namespace demold

#endif

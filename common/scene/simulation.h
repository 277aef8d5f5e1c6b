// SPDX-License-Identifier: LGPL-2.1-or-later
// A scene brought to life: mesh, terms, strategy, records.
#ifndef demold_scene_simulation_h
#define demold_scene_simulation_h

#include "base/run_step.h"
#include "scene/scene.h"
#include "scene/scene_parameters.h"

#include <string>

namespace demold
{
  /// Runs @p scene with @p parameters: builds the list of terms the scene
  /// calls for and nothing else, lets the strategy solve it, writes what the
  /// contract promises (README, what comes out).
  template <int dim>
  RunStatus run_simulation(const Scene<dim>      &scene,
                           const SceneParameters &parameters,
                           const RunContext      &context);

  /// What the scene will simulate, in words: terms, unknowns, memory, Omega
  /// and l_cz.
  template <int dim>
  std::string preview_simulation(const Scene<dim>      &scene,
                                 const SceneParameters &parameters);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// What an accepted increment shows: force, areas, energies, extremes.
#ifndef demold_scene_observe_h
#define demold_scene_observe_h

#include "scene/recorder.h"
#include "scene/scene_system.h"
#include "solution/strategy.h"

namespace demold
{
  /// Force [N] in the opening direction at @p time, measured where the scene
  /// says, of the whole block. Collective.
  template <int dim>
  double measured_force(const Scene<dim>       &scene,
                        const SceneSystem<dim> &system,
                        double                  time);

  /// The state of @p system after the increment of @p record, of the whole
  /// block. Collective.
  template <int dim>
  Observation observe(const Scene<dim>       &scene,
                      const SceneSystem<dim> &system,
                      const IncrementRecord  &record);
} // namespace demold

#endif

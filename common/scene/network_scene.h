// SPDX-License-Identifier: LGPL-2.1-or-later
// A network of springs, bars and bonds: from entries to records.
#ifndef demold_scene_network_scene_h
#define demold_scene_network_scene_h

#include "base/run_step.h"
#include "scene/network_entries.h"
#include "scene/scene_parameters.h"

#include <string>

namespace demold
{
  /// What a network needs beyond the parameters that all scenes share: the
  /// sections Adhesion, Solution, Solver and Output count, those of bodies do
  /// not. Strategies are the same as for bodies.
  struct NetworkScene
  {
    NetworkEntries network;

    void add_parameters(dealii::ParameterHandler &prm);
    void check(const SceneParameters &parameters) const;

    std::string preview() const;
    RunStatus   run(const SceneParameters &parameters,
                    const RunContext      &context) const;
  };
} // namespace demold

#endif

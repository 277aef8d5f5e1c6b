// SPDX-License-Identifier: LGPL-2.1-or-later
// One body over a mould or over a second body: from entries to a scene.
#ifndef demold_scene_body_scene_h
#define demold_scene_body_scene_h

#include "base/run_step.h"
#include "scene/body_entries.h"
#include "scene/mould_entries.h"
#include "scene/process_entries.h"
#include "scene/scene_parameters.h"
#include "scene/support_entries.h"

#include <string>

namespace demold
{
  /// The parameter file from top to bottom, and what a step does with it.
  struct BodyScene
  {
    SceneParameters scene;
    BodyEntries     bodies;
    MouldEntries    mould;
    SupportEntries  supports;
    ProcessEntries  process;

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;

    /// The scene, which is not to outlive this.
    template <int dim>
    Scene<dim> make_scene() const;

    std::string preview() const;
    RunStatus   run(const RunContext &context) const;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// A tread block in its mould: from entries to a scene.
#ifndef demold_scene_tread_scene_h
#define demold_scene_tread_scene_h

#include "base/run_step.h"
#include "geometry/mesh_file.h"
#include "geometry/tread_block.h"
#include "scene/fixing.h"
#include "scene/pull.h"
#include "scene/scene_parameters.h"

#include <string>

namespace demold
{
  /// The block, what is behind it and the mould that leaves it (thesis 7.1).
  /// What all scenes share, and section Pull, come from the caller.
  struct TreadScene
  {
    TreadBlock block;
    Fixing     fixing;
    MeshFiles  files;

    void add_parameters(dealii::ParameterHandler &prm);
    void check(const SceneParameters &parameters, const Pull &pull) const;

    /// The scene, which is not to outlive this and @p pull.
    template <int dim>
    Scene<dim> make_scene(const SceneParameters &parameters,
                          const Pull            &pull) const;

    std::string preview(const SceneParameters &parameters,
                        const Pull            &pull) const;
    RunStatus   run(const SceneParameters &parameters,
                    const Pull            &pull,
                    const RunContext      &context) const;

  private:
    TreadBlock fixed_block() const;
    void       check_symmetry(const Pull &pull, int dim) const;
  };
} // namespace demold

#endif

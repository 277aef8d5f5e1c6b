// SPDX-License-Identifier: LGPL-2.1-or-later
// When to draw rubber and mould for ParaView: always both, at the same times.
#ifndef demold_scene_scene_fields_h
#define demold_scene_scene_fields_h

#include "scene/field_output.h"
#include "scene/mould_output.h"
#include "scene/scene_system.h"

#include <memory>
#include <string>
#include <vector>

namespace demold
{
  /// The pictures of a run: before the first increment, after every n-th as
  /// `Output/fields every` says, and after the last one. None if that is 0.
  template <int dim>
  class SceneFields
  {
  public:
    /// @p scene and @p system must live as long as this.
    SceneFields(const Scene<dim>       &scene,
                const SceneParameters  &parameters,
                const SceneSystem<dim> &system,
                const std::string      &output_folder);

    /// All collective. @p increments accepted since the run began.
    void write_first();
    void write_if_due(unsigned int increments);
    void write_last(unsigned int increments);

    /// Times [s] of the pictures so far, for a checkpoint.
    std::vector<double> times() const;
    void                restart(const std::vector<double> &times);

  private:
    void write();

    const SceneSystem<dim>           &system;
    const unsigned int                every;
    std::unique_ptr<FieldOutput<dim>> rubber;
    std::unique_ptr<MouldOutput<dim>> mould;
  };
} // namespace demold

#endif

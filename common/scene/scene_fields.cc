// SPDX-License-Identifier: LGPL-2.1-or-later
// When to draw rubber and mould for ParaView: always both, at the same times.
#include "scene/scene_fields.h"

namespace demold
{
  template <int dim>
  SceneFields<dim>::SceneFields(const Scene<dim>       &scene,
                                const SceneParameters  &parameters,
                                const SceneSystem<dim> &system,
                                const std::string      &output_folder)
    : system(system)
    , every(parameters.fields_every)
  {
    if (every == 0)
      return;
    rubber =
      std::make_unique<FieldOutput<dim>>(system.dof_handler,
                                         system.solids,
                                         parameters.interface.search_distance,
                                         output_folder);
    if (scene.mould)
      mould = std::make_unique<MouldOutput<dim>>(*scene.mould,
                                                 scene.motion,
                                                 output_folder);
  }

  template <int dim>
  void SceneFields<dim>::write()
  {
    const WeakForm &weak_form = *system.weak_form;
    rubber->write(weak_form.accepted, system.interface, weak_form.time());
    if (mould)
      mould->write(weak_form.time());
  }

  template <int dim>
  void SceneFields<dim>::write_first()
  {
    if (every > 0)
      write();
  }

  template <int dim>
  void SceneFields<dim>::write_if_due(const unsigned int increments)
  {
    if (every > 0 && increments % every == 0)
      write();
  }

  template <int dim>
  void SceneFields<dim>::write_last(const unsigned int increments)
  {
    if (every > 0 && increments % every != 0)
      write();
  }

  template <int dim>
  std::vector<double> SceneFields<dim>::times() const
  {
    return rubber ? rubber->series.times() : std::vector<double>();
  }

  template <int dim>
  void SceneFields<dim>::restart(const std::vector<double> &times)
  {
    if (rubber)
      rubber->series.restart(times);
    if (mould)
      mould->series.restart(times);
  }

  template class SceneFields<2>;
  template class SceneFields<3>;
} // namespace demold

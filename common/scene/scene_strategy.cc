// SPDX-License-Identifier: LGPL-2.1-or-later
// From the entry Solution/strategy to something that solves the scene.
#include "scene/scene_strategy.h"

#include "solid/lumped_mass.h"
#include "solution/automatic.h"
#include "solution/central_differences.h"
#include "solution/dynamics.h"
#include "solution/explicit_dynamics.h"
#include "solution/path_following.h"
#include "solution/quasi_static.h"

#include <algorithm>

namespace demold
{
  namespace
  {
    /// The entries of section Solution, with the scene's choice for those left
    /// at zero.
    IncrementParameters increments_of(const SceneParameters &parameters,
                                      const double           end_time,
                                      IncrementState        &state)
    {
      IncrementParameters increments = parameters.increments;
      if (increments.largest <= 0.)
        increments.largest = end_time / (parameters.is_explicit() ? 500. : 50.);
      if (increments.first <= 0.)
        increments.first = std::min(increments.largest, end_time / 200.);
      if (increments.smallest <= 0.)
        increments.smallest = 1e-9 * end_time;
      increments.state = &state;
      return increments;
    }

    PathTools path_tools(const SceneParameters &parameters,
                         const StrategyTools   &tools)
    {
      return {tools.newton,
              tools.linear_solver,
              parameters.newton,
              parameters.path,
              tools.note};
    }

    /// Errors of the displacement are judged by the gap over which a bond lets
    /// go, or by the height of the rubber.
    template <int dim>
    Inertia &add_inertia(const Scene<dim>      &scene,
                         const SceneParameters &parameters,
                         SceneSystem<dim>      &system)
    {
      const auto  &adhesion = parameters.interface.adhesion;
      const double length =
        parameters.accuracy *
        (adhesion.active() ? adhesion.rupture_gap : .1 * scene.height);
      auto inertia =
        std::make_unique<Inertia>(lumped_mass<dim>(system.dof_handler,
                                                   parameters.plane(),
                                                   parameters.material.density,
                                                   system.weak_form->trial),
                                  parameters.integrator,
                                  length);
      Inertia &term = *inertia;
      system.weak_form->add(std::move(inertia));
      return term;
    }

    template <int dim>
    CentralDifferences &add_motion(const SceneParameters &parameters,
                                   SceneSystem<dim>      &system)
    {
      const double density =
        parameters.material.density * parameters.explicit_dynamics.mass_scaling;
      auto motion = std::make_unique<CentralDifferences>(
        lumped_mass<dim>(system.dof_handler,
                         parameters.plane(),
                         density,
                         system.weak_form->trial));
      CentralDifferences &term = *motion;
      system.weak_form->add(std::move(motion));
      return term;
    }
  } // namespace

  Strategy make_strategy(const SceneParameters &parameters,
                         const StrategyTools   &tools,
                         IncrementState        &state)
  {
    const IncrementParameters increments =
      increments_of(parameters, tools.end_time, state);
    if (parameters.strategy == "arc length")
      return [=, &parameters](const OnAccept &on_accept) {
        return run_path_following(tools.weak_form,
                                  path_tools(parameters, tools),
                                  increments,
                                  tools.end_time,
                                  on_accept);
      };
    return [=](const OnAccept &on_accept) {
      return run_quasi_static(tools.weak_form,
                              tools.newton,
                              increments,
                              tools.end_time,
                              on_accept);
    };
  }

  template <int dim>
  Strategy make_strategy(const Scene<dim>      &scene,
                         const SceneParameters &parameters,
                         SceneSystem<dim>      &system,
                         const StrategyTools   &tools,
                         IncrementState        &state)
  {
    if (!parameters.has_inertia())
      return make_strategy(parameters, tools, state);
    const IncrementParameters increments =
      increments_of(parameters, tools.end_time, state);
    const double factor = scene.symmetry_factor;
    if (parameters.is_explicit())
      return [=, &parameters, &motion = add_motion(parameters, system)](
               const OnAccept &on_accept) {
        return run_explicit_dynamics(tools.weak_form,
                                     {motion,
                                      parameters.explicit_dynamics,
                                      tools.newton.seconds_assembly,
                                      factor,
                                      tools.note},
                                     increments,
                                     tools.end_time,
                                     on_accept);
      };
    Inertia &inertia = add_inertia(scene, parameters, system);
    // By mortar the ledger is open where faces slide over sharp ends, which a
    // path takes for a jump.
    const bool detours =
      !parameters.damage_is_viscous() && !parameters.interface.is_mortar();
    if (parameters.strategy == "automatic")
      return [=, &parameters, &inertia](const OnAccept &on_accept) {
        return run_automatic(tools.weak_form,
                             {path_tools(parameters, tools),
                              inertia,
                              parameters.integrator,
                              factor,
                              detours},
                             increments,
                             tools.end_time,
                             on_accept);
      };
    return [=, &parameters, &inertia](const OnAccept &on_accept) {
      return run_dynamics(tools.weak_form,
                          tools.newton,
                          inertia,
                          parameters.integrator,
                          increments,
                          tools.end_time,
                          on_accept);
    };
  }

  template Strategy make_strategy<2>(const Scene<2> &,
                                     const SceneParameters &,
                                     SceneSystem<2> &,
                                     const StrategyTools &,
                                     IncrementState &);
  template Strategy make_strategy<3>(const Scene<3> &,
                                     const SceneParameters &,
                                     SceneSystem<3> &,
                                     const StrategyTools &,
                                     IncrementState &);
} // namespace demold

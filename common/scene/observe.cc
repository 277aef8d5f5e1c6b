// SPDX-License-Identifier: LGPL-2.1-or-later
// What an accepted increment shows: force, areas, energies, extremes.
#include "scene/observe.h"

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace demold
{
  using namespace dealii;

  template <int dim>
  double measured_force(const Scene<dim>       &scene,
                        const SceneSystem<dim> &system,
                        const double            time)
  {
    const Vector &reactions = system.weak_form->force;
    if (scene.force_on == Scene<dim>::ForceOn::supports)
      {
        const double dt = 1e-6 * scene.end_time;
        return system.supports->power(time, dt, reactions) * 2. * dt /
               (scene.opening(time + dt) - scene.opening(time - dt)) *
               scene.symmetry_factor;
      }
    Tensor<1, 3> force;
    if (scene.force_on == Scene<dim>::ForceOn::boundary)
      force = system.supports->reaction(scene.force_boundary, reactions);
    else if (system.interface != nullptr)
      force = system.interface->sums().force;
    return force * scene.direction(time) * scene.symmetry_factor;
  }

  template <int dim>
  Observation observe(const Scene<dim>       &scene,
                      const SceneSystem<dim> &system,
                      const IncrementRecord  &record)
  {
    Observation now;
    now.time    = record.path ? record.path->clock : record.time;
    now.opening = scene.opening(record.time);
    now.force   = measured_force(scene, system, record.time);
    auto e      = system.weak_form->energies().as_array();
    for (double &entry : e)
      entry *= scene.symmetry_factor;
    now.energies = Energies::from_array(e);
    if (system.interface != nullptr)
      {
        const InterfaceSums sums = system.interface->sums();
        now.bonded               = sums.bonded * scene.symmetry_factor;
        now.closed               = sums.closed * scene.symmetry_factor;
        now.area                 = sums.area * scene.symmetry_factor;
      }
    for (const CellResults *solid : system.rubber)
      for (const CellResult &cell : solid->cell_results())
        {
          now.stretch = std::max(now.stretch, cell.largest_stretch);
          now.tension = std::max(now.tension, cell.largest_tension);
        }
    now.stretch    = Utilities::MPI::max(now.stretch, system.communicator);
    now.tension    = Utilities::MPI::max(now.tension, system.communicator);
    now.iterations = record.newton.iterations;
    now.rejected   = record.rejected;
    now.strategy   = record.strategy;
    now.path       = record.path;
    if (now.path)
      {
        now.path->released *= scene.symmetry_factor;
        now.path->damped *= scene.symmetry_factor;
      }
    now.done = now.time / scene.end_time;
    return now;
  }

  template double      measured_force<2>(const Scene<2> &,
                                    const SceneSystem<2> &,
                                    double);
  template double      measured_force<3>(const Scene<3> &,
                                    const SceneSystem<3> &,
                                    double);
  template Observation observe<2>(const Scene<2> &,
                                  const SceneSystem<2> &,
                                  const IncrementRecord &);
  template Observation observe<3>(const Scene<3> &,
                                  const SceneSystem<3> &,
                                  const IncrementRecord &);
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// From a scene to its mesh, its unknowns and its list of terms.
#ifndef demold_scene_scene_system_h
#define demold_scene_scene_system_h

#include "contact/interface_term.h"
#include "scene/scene.h"
#include "scene/scene_parameters.h"
#include "scene/scene_supports.h"
#include "scene/vulcanised_cure.h"
#include "solid/cell_results.h"
#include "weak_form/weak_form.h"

#include <deal.II/distributed/shared_tria.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>

#include <memory>
#include <vector>

namespace demold
{
  /// Is there anything that may touch, and shall it?
  template <int dim>
  bool has_interface(const Scene<dim>      &scene,
                     const SceneParameters &parameters);

  /// What a strategy solves and what others look at: exactly the terms the
  /// scene calls for, one solid per material id of the mesh, one dead traction
  /// per rule, the interface. A strategy may add terms of its own.
  template <int dim>
  struct SceneSystem
  {
    /// @p scene and @p parameters must live as long as this.
    SceneSystem(const Scene<dim>      &scene,
                const SceneParameters &parameters,
                MPI_Comm               communicator);

    SceneSystem(const SceneSystem &)            = delete;
    SceneSystem &operator=(const SceneSystem &) = delete;

    const MPI_Comm                               communicator;
    dealii::parallel::shared::Triangulation<dim> triangulation;
    const dealii::FESystem<dim>                  fe;
    dealii::DoFHandler<dim>                      dof_handler;
    std::unique_ptr<SceneSupports>               supports;
    std::unique_ptr<WeakForm>                    weak_form;
    std::vector<const CellResults *>             solids; ///< a view each
    std::vector<const CellResults *> rubber; ///< those of section Material
    InterfaceTerm *interface = nullptr;      ///< null: nothing may touch
    std::unique_ptr<const VulcanisedCure<dim>> cure; ///< null: by formula
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// From a scene to its mesh, its unknowns and its list of terms.
#include "scene/scene_system.h"

#include "contact/node_to_segment.h"
#include "mortar/mortar_term.h"
#include "scene/expression.h"
#include "solid/dead_traction.h"
#include "solid/finite_strain_solid.h"
#include "weak_form/displacement_space.h"

#include <deal.II/fe/fe_q.h>

#include <set>

namespace demold
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::set<types::material_id>
    material_ids(const DoFHandler<dim> &dof_handler)
    {
      std::set<types::material_id> ids;
      for (const auto &cell : dof_handler.active_cell_iterators())
        ids.insert(cell->material_id());
      return ids;
    }

    /// f90 [-] of a reference position.
    template <int dim>
    std::function<double(const dealii::Point<3> &)>
    state_of_cure(const SceneSystem<dim> &system, const RubberModel &rubber)
    {
      if (system.cure != nullptr)
        return [&cure = *system.cure](const dealii::Point<3> &X) {
          return cure.f90(X);
        };
      const auto formula =
        std::make_shared<Expression>(rubber.f90_expression(), "Material/f90");
      return [formula](const dealii::Point<3> &X) { return (*formula)(0., X); };
    }

    template <int dim>
    void add_solids(SceneSystem<dim>      &system,
                    const Scene<dim>      &scene,
                    const SceneParameters &parameters)
    {
      const RubberModel &rubber = parameters.material;
      const auto         f90    = state_of_cure(system, rubber);
      for (const auto id : material_ids(system.dof_handler))
        {
          SolidDescription description;
          description.material_id = id;
          description.element     = parameters.element;
          description.plane       = parameters.plane();
          const auto other        = scene.laws.find(id);
          const bool is_rubber    = other == scene.laws.end();
          if (is_rubber)
            {
              description.uniform_law =
                system.cure == nullptr && rubber.f90_is_uniform();
              description.law = [&rubber, f90](const dealii::Point<3> &X) {
                return rubber.at(f90(X));
              };
              description.f90 = f90;
            }
          else
            description.law = [law = other->second](const dealii::Point<3> &) {
              return law;
            };
          const Term &solid = system.weak_form->add(
            make_solid_term<dim>(system.dof_handler, description));
          system.solids.push_back(dynamic_cast<const CellResults *>(&solid));
          if (is_rubber)
            system.rubber.push_back(system.solids.back());
        }
    }

    template <int dim>
    void add_tractions(SceneSystem<dim>      &system,
                       const Scene<dim>      &scene,
                       const SceneParameters &parameters)
    {
      for (const TractionRule &rule : scene.tractions)
        system.weak_form->add(make_dead_traction<dim>(system.dof_handler,
                                                      rule.boundary,
                                                      rule.traction,
                                                      parameters.plane()));
    }

    Master rigid_master(const RigidSurface &mould, const RigidMotion &motion)
    {
      std::vector<Facet> facets;
      for (const auto &facet : mould.facets)
        facets.push_back({facet.v, facet.n});
      return Master::rigid(facets, mould.vertices, motion);
    }

    template <int dim>
    void add_interface(SceneSystem<dim>      &system,
                       const Scene<dim>      &scene,
                       const SceneParameters &parameters)
    {
      BoundarySurface slave =
        extract_surface<dim>(system.dof_handler, scene.slave);
      Master master =
        scene.mould ? rigid_master(*scene.mould, scene.motion) :
                      Master::deformable(
                        extract_surface<dim>(system.dof_handler, scene.master));
      const InterfaceDescription description = parameters.interface.description(
        parameters.plane(),
        parameters.typical_law().young_instantaneous());
      const IndexSet &owned = system.dof_handler.locally_owned_dofs();
      std::unique_ptr<InterfaceTerm> term;
      if (parameters.interface.is_mortar())
        term = std::make_unique<MortarTerm>(std::move(slave),
                                            std::move(master),
                                            description,
                                            owned,
                                            system.supports->is_held(),
                                            system.communicator);
      else
        term = std::make_unique<NodeToSegment>(std::move(slave),
                                               std::move(master),
                                               description,
                                               owned,
                                               system.communicator);
      system.interface = term.get();
      system.weak_form->add(std::move(term));
    }
  } // namespace

  template <int dim>
  bool has_interface(const Scene<dim> &scene, const SceneParameters &parameters)
  {
    return parameters.interface.active() && !scene.slave.empty();
  }

  template <int dim>
  SceneSystem<dim>::SceneSystem(const Scene<dim>      &scene,
                                const SceneParameters &parameters,
                                MPI_Comm               communicator)
    : communicator(communicator)
    , triangulation(
        communicator,
        Triangulation<dim>::none,
        false,
        parallel::shared::Triangulation<dim>::Settings::partition_metis)
    , fe(FE_Q<dim>(parameters.element == "q2" ? 2 : 1), dim)
    , dof_handler(triangulation)
  {
    scene.make_mesh(triangulation);
    dof_handler.distribute_dofs(fe);
    supports = std::make_unique<SceneSupports>(
      collect_supports(dof_handler, scene.supports));
    weak_form = std::make_unique<WeakForm>(displacement_space<dim>(dof_handler),
                                           supports->supports());
    if (parameters.vulcanised())
      cure = std::make_unique<const VulcanisedCure<dim>>(scene, parameters);
    add_solids(*this, scene, parameters);
    add_tractions(*this, scene, parameters);
    if (has_interface(scene, parameters))
      add_interface(*this, scene, parameters);
    weak_form->setup();
  }

  template bool has_interface<2>(const Scene<2> &, const SceneParameters &);
  template bool has_interface<3>(const Scene<3> &, const SceneParameters &);
  template struct SceneSystem<2>;
  template struct SceneSystem<3>;
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// What a scene will simulate, in words, before anything is computed.
#include "adhesion/stability_number.h"
#include "scene/scene_supports.h"
#include "scene/simulation.h"

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Longest edge [mm] of the faces that may stick.
    template <int dim>
    double largest_edge(const Triangulation<dim>           &mesh,
                        const std::set<types::boundary_id> &boundaries)
    {
      double largest = 0.;
      for (const auto &cell : mesh.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && boundaries.count(face->boundary_id()) > 0)
            {
              if constexpr (dim == 2)
                largest = std::max(largest, face->measure());
              else
                for (unsigned int e = 0; e < face->n_lines(); ++e)
                  largest = std::max(largest, face->line(e)->measure());
            }
      return largest;
    }

    std::string mesh_warning(const double edge, const double cohesive_zone)
    {
      std::ostringstream text;
      if (edge > cohesive_zone / 3.)
        text << "WARNING: interface elements reach " << edge
             << " mm, above l_cz/3 = " << cohesive_zone / 3.
             << " mm: the cohesive zone is not resolved, force and jumps will "
                "depend on the mesh. Make elements smaller, or lower the "
                "strength at equal G_c.\n";
      return text.str();
    }

    std::string cure_text(const SceneParameters &parameters)
    {
      if (!parameters.vulcanised())
        return "";
      std::ostringstream text;
      text << "  cure        computed from a press cycle of "
           << parameters.press.cycle().opening_time << " s\n";
      return text.str();
    }

    template <int dim>
    std::string interface_text(const Scene<dim>          &scene,
                               const InterfaceParameters &interface)
    {
      std::ostringstream text;
      text << "  contact     "
           << (scene.slave.empty() ? "none" : interface.formulation)
           << (interface.is_mortar() && !scene.slave.empty() ?
                 ", " + interface.multipliers + " multipliers" :
                 "")
           << (scene.mould ?
                 ", rigid mould of " +
                   std::to_string(scene.mould->facets.size()) + " facets" :
                 "")
           << "\n  adhesion    " << interface.adhesion.law_name
           << "\n  friction    ";
      if (interface.friction > 0.)
        text << "mu = " << interface.friction << '\n';
      else
        text << "none\n";
      return text.str();
    }

    std::string memory_text(const double history,
                            const double unknowns,
                            const int    dim)
    {
      std::ostringstream text;
      text << "  memory      history " << std::setprecision(3)
           << history / (1 << 20) << " MiB, direct factor about "
           << (dim == 2 ? unknowns * 1e-3 :
                          1.2e-5 * std::pow(unknowns, 4. / 3.))
           << " MiB\n";
      return text.str();
    }

    template <int dim>
    std::string stability_text(const Scene<dim>          &scene,
                               const InterfaceParameters &interface,
                               const RubberLaw           &law,
                               const Triangulation<dim>  &mesh)
    {
      if (!interface.adhesion.active() || scene.slave.empty())
        return "";
      const StabilityPreview stability =
        stability_preview(interface.adhesion.law().softening,
                          law.young_relaxed(),
                          law.young_instantaneous(),
                          law.poisson_relaxed(),
                          scene.height);
      return stability.text() + mesh_warning(largest_edge(mesh, scene.slave),
                                             stability.relaxed.cohesive_zone);
    }
    /// Throws where a part of a boundary that is to be driven has no nodes.
    template <int dim>
    void check_supports(const Scene<dim>         &scene,
                        const unsigned int        degree,
                        const Triangulation<dim> &mesh)
    {
      if (std::none_of(scene.supports.begin(),
                       scene.supports.end(),
                       [](const SupportRule &rule) {
                         return bool(rule.where);
                       }))
        return;
      const FESystem<dim> fe(FE_Q<dim>(degree), dim);
      DoFHandler<dim>     nodes(mesh);
      nodes.distribute_dofs(fe);
      collect_supports(nodes, scene.supports);
    }
  } // namespace

  template <int dim>
  std::string preview_simulation(const Scene<dim>      &scene,
                                 const SceneParameters &parameters)
  {
    Triangulation<dim> mesh;
    scene.make_mesh(mesh);
    const unsigned int degree = parameters.element == "q2" ? 2 : 1;
    check_supports(scene, degree, mesh);
    const double unknowns =
      degree == 1 ? dim * static_cast<double>(mesh.n_used_vertices()) :
                    dim * std::pow(2., dim) * mesh.n_active_cells();
    const RubberLaw law = parameters.typical_law();
    const auto      history =
      static_cast<double>(law.n_history() * mesh.n_active_cells()) *
      std::pow(degree + 1, dim) * 16.;

    std::ostringstream text;
    text << "What will be simulated\n"
         << "  rubber      " << parameters.element << ", "
         << mesh.n_active_cells() << " cells, about "
         << static_cast<long>(unknowns) << " unknowns, " << law.branches.size()
         << " Maxwell branches\n"
         << cure_text(parameters) << interface_text(scene, parameters.interface)
         << "  strategy    " << parameters.strategy << " until "
         << scene.end_time << " s at the latest\n"
         << memory_text(history, unknowns, dim)
         << stability_text(scene, parameters.interface, law, mesh);
    return text.str();
  }

  template std::string preview_simulation<2>(const Scene<2> &,
                                             const SceneParameters &);
  template std::string preview_simulation<3>(const Scene<3> &,
                                             const SceneParameters &);
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// From support rules to prescribed unknowns and their reactions.
#include "scene/scene_supports.h"

#include "base/parameter_error.h"
#include "base/plane_model.h"

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping_q1.h>

#include <set>

namespace demold
{
  using namespace dealii;

  SceneSupports::SceneSupports(std::vector<SupportRule> rules,
                               std::vector<Entry>       entries)
    : rules(std::move(rules))
    , entries(std::move(entries))
  {}

  Supports SceneSupports::supports() const
  {
    Supports result;
    for (const Entry &entry : entries)
      result.unknowns.push_back(entry.unknown);
    result.values = [this](const double t, std::vector<double> &values) {
      for (std::size_t k = 0; k < entries.size(); ++k)
        values[k] = rules[entries[k].rule].value(t, entries[k].X);
    };
    return result;
  }

  std::function<bool(types::global_dof_index)> SceneSupports::is_held() const
  {
    std::set<types::global_dof_index> held;
    for (const Entry &entry : entries)
      held.insert(entry.unknown);
    return
      [held](const types::global_dof_index i) { return held.count(i) > 0; };
  }

  Tensor<1, 3> SceneSupports::reaction(const types::boundary_id boundary,
                                       const Vector            &force) const
  {
    Tensor<1, 3>   sum;
    const IndexSet owned = force.locally_owned_elements();
    for (const Entry &entry : entries)
      if (rules[entry.rule].boundary == boundary &&
          owned.is_element(entry.unknown))
        sum[rules[entry.rule].component] += force(entry.unknown);
    return Utilities::MPI::sum(sum, force.get_mpi_communicator());
  }

  double SceneSupports::power(const double  t,
                              const double  dt,
                              const Vector &force) const
  {
    double         sum   = 0.;
    const IndexSet owned = force.locally_owned_elements();
    for (const Entry &entry : entries)
      if (owned.is_element(entry.unknown))
        {
          const auto &u = rules[entry.rule].value;
          sum +=
            force(entry.unknown) * (u(t + dt, entry.X) - u(t - dt, entry.X));
        }
    return Utilities::MPI::sum(sum, force.get_mpi_communicator()) / (2. * dt);
  }

  template <int dim>
  SceneSupports collect_supports(const DoFHandler<dim, dim>     &dof_handler,
                                 const std::vector<SupportRule> &rules)
  {
    std::map<types::global_dof_index, SceneSupports::Entry> entries;
    std::vector<types::global_dof_index>                    indices(
      dof_handler.get_fe().n_dofs_per_cell());
    const auto &fe = dof_handler.get_fe();
    for (unsigned int r = 0; r < rules.size(); ++r)
      {
        const SupportRule &rule  = rules[r];
        bool               found = false;
        for (const auto &cell : dof_handler.active_cell_iterators())
          {
            const auto add = [&](const auto &concerned) {
              cell->get_dof_indices(indices);
              for (unsigned int i = 0; i < indices.size(); ++i)
                if (fe.system_to_component_index(i).first == rule.component &&
                    concerned(i))
                  {
                    const Point<3> X = in_space(
                      StaticMappingQ1<dim>::mapping.transform_unit_to_real_cell(
                        cell,
                        fe.unit_support_point(i)));
                    if (rule.where && !rule.where(X))
                      continue;
                    found = true;
                    entries.insert({indices[i], {indices[i], r, X}});
                  }
            };
            if (!rule.boundary)
              add([](unsigned int) { return true; });
            else
              for (const unsigned int f : cell->face_indices())
                if (cell->face(f)->at_boundary() &&
                    cell->face(f)->boundary_id() == *rule.boundary)
                  add([&](const unsigned int i) {
                    return fe.has_support_on_face(i, f);
                  });
          }
        if (rule.where && !found)
          throw ExcParameter("Supports/driven where",
                             "must be positive at one node at least for every "
                             "part of Supports/driven; got none for its "
                             "component " +
                               std::string(1, "xyz"[rule.component]) +
                               ". Compare it with the size of the body and of "
                               "its elements.");
      }
    std::vector<SceneSupports::Entry> list;
    for (const auto &entry : entries)
      list.push_back(entry.second);
    return {rules, list};
  }

  template SceneSupports collect_supports<2>(const DoFHandler<2, 2> &,
                                             const std::vector<SupportRule> &);
  template SceneSupports collect_supports<3>(const DoFHandler<3, 3> &,
                                             const std::vector<SupportRule> &);
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// ParaView files of the rubber: displacement, stress, cure, interface.
#include "scene/field_output.h"

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <list>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// A vector DataOut can read: the entries of the cells of this rank,
    /// @p fill writes those it knows.
    template <int dim, typename Fill>
    Vector readable(const DoFHandler<dim> &dof_handler, const Fill &fill)
    {
      IndexSet relevant;
      DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
      const IndexSet &owned = dof_handler.locally_owned_dofs();
      Vector          own(owned, MPI_COMM_WORLD);
      fill(own);
      own.compress(VectorOperation::insert);
      Vector result(owned, relevant, MPI_COMM_WORLD);
      result = own;
      return result;
    }

    struct CellField
    {
      std::string           name;
      dealii::Vector<float> values;
    };

    template <int dim>
    std::vector<CellField>
    cell_fields(const unsigned int                      n_cells,
                const std::vector<const CellResults *> &solids)
    {
      // In a plane the shears out of it vanish.
      constexpr unsigned int n_stresses = dim == 2 ? 4 : 6;
      const char *const components[]    = {"xx", "yy", "zz", "xy", "xz", "yz"};
      std::vector<CellField> fields;
      for (unsigned int I = 0; I < n_stresses; ++I)
        fields.push_back({std::string("stress_") + components[I], {}});
      for (const char *const name :
           {"largest_principal_tension", "largest_principal_stretch", "cure"})
        fields.push_back({name, {}});
      for (CellField &field : fields)
        field.values.reinit(n_cells);
      for (const CellResults *solid : solids)
        for (const CellResult &cell : solid->cell_results())
          {
            for (unsigned int I = 0; I < n_stresses; ++I)
              fields[I].values(cell.index) = cell.stress[I];
            fields[n_stresses].values(cell.index)     = cell.largest_tension;
            fields[n_stresses + 1].values(cell.index) = cell.largest_stretch;
            fields[n_stresses + 2].values(cell.index) = cell.f90;
          }
      return fields;
    }
  } // namespace

  template <int dim>
  FieldOutput<dim>::FieldOutput(const DoFHandler<dim, dim> &dof_handler,
                                const std::vector<const CellResults *> &solids,
                                const double       search_distance,
                                const std::string &output_folder)
    : series(output_folder, "fields", "")
    , dof_handler(dof_handler)
    , solids(solids)
    , search_distance(search_distance)
    , node_element(dof_handler.get_fe().degree)
    , nodes(dof_handler.get_triangulation())
  {
    nodes.distribute_dofs(node_element);
    find_nodes();
  }

  template <int dim>
  void FieldOutput<dim>::find_nodes()
  {
    const auto                          &fe = dof_handler.get_fe();
    std::vector<types::global_dof_index> unknowns(fe.n_dofs_per_cell());
    std::vector<types::global_dof_index> numbers(
      node_element.n_dofs_per_cell());
    // Both handlers run over the same cells.
    auto node_cell = nodes.begin_active();
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        if (cell->at_boundary())
          {
            cell->get_dof_indices(unknowns);
            node_cell->get_dof_indices(numbers);
            for (unsigned int i = 0; i < unknowns.size(); ++i)
              {
                const auto component = fe.system_to_component_index(i);
                if (component.first == 0)
                  node_of_unknown[unknowns[i]] = numbers[component.second];
              }
          }
        ++node_cell;
      }
  }

  template <int dim>
  std::vector<typename FieldOutput<dim>::PointField>
  FieldOutput<dim>::point_fields(const InterfaceTerm &interface) const
  {
    std::vector<PointField> fields = {{"contact_pressure", 0., {}},
                                      {"damage", 0., {}},
                                      {"interface_state", -1., {}},
                                      {"gap", 0., {}}};
    const auto merge = [](auto &field, const auto node, const double value) {
      const auto [entry, is_new] = field.values.emplace(node, value);
      if (!is_new)
        entry->second = std::max(entry->second, value);
    };
    for (const PointReport &p : interface.report())
      {
        const auto node = node_of_unknown.at(p.node.unknowns[0]);
        merge(fields[0], node, p.pressure);
        merge(fields[1], node, p.damage);
        merge(fields[2], node, p.state);
        merge(fields[3], node, -std::min(p.gap, search_distance));
      }
    for (auto &[node, gap] : fields[3].values) // the smallest gap
      gap = -gap;
    return fields;
  }

  template <int dim>
  void FieldOutput<dim>::write(const Vector        &displacement,
                               const InterfaceTerm *interface,
                               const double         time)
  {
    DataOut<dim> data;
    data.attach_dof_handler(dof_handler);
    // Extra unknowns end here: only displacements are fields.
    const Vector u = readable(dof_handler, [&](Vector &v) {
      for (const auto i : dof_handler.locally_owned_dofs())
        v(i) = displacement(i);
    });
    data.add_data_vector(
      u,
      std::vector<std::string>(dim, "displacement"),
      DataOut<dim>::type_dof_data,
      std::vector<DataComponentInterpretation::DataComponentInterpretation>(
        dim,
        DataComponentInterpretation::component_is_part_of_vector));

    std::list<Vector> point_data; // DataOut keeps addresses
    if (interface != nullptr)
      for (const PointField &field : point_fields(*interface))
        {
          point_data.push_back(readable(nodes, [&](Vector &v) {
            v = field.elsewhere;
            for (const auto &[node, value] : field.values)
              v(node) = value;
          }));
          data.add_data_vector(nodes, point_data.back(), field.name);
        }
    const std::vector<CellField> cell_data =
      cell_fields<dim>(dof_handler.get_triangulation().n_active_cells(),
                       solids);
    for (const CellField &field : cell_data)
      data.add_data_vector(field.values,
                           field.name,
                           DataOut<dim>::type_cell_data);
    data.build_patches(dof_handler.get_fe().degree);

    DataOutBase::VtkFlags flags(time);
    flags.compression_level = DataOutBase::VtkFlags::best_speed;
    data.set_flags(flags);
    data.write_vtu_in_parallel(series.next_file(), MPI_COMM_WORLD);
    series.add(time);
  }

  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace demold

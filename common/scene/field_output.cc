// SPDX-License-Identifier: LGPL-2.1-or-later
// ParaView files of displacement and interface state.
#include "scene/field_output.h"

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/numerics/data_out.h>

#include <filesystem>
#include <fstream>

namespace demold
{
  using namespace dealii;

  template <int dim>
  FieldOutput<dim>::FieldOutput(const DoFHandler<dim, dim> &dof_handler,
                                const std::string &         output_folder)
    : dof_handler(dof_handler)
    , output_folder(output_folder)
  {}

  template <int dim>
  void FieldOutput<dim>::write(const Vector &       displacement,
                               const NodeToSegment *interface,
                               const double         time)
  {
    const MPI_Comm communicator = MPI_COMM_WORLD;
    IndexSet       relevant;
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
    const IndexSet &owned = dof_handler.locally_owned_dofs();

    // Extra unknowns end here: only displacements are fields.
    const auto field = [&](const auto &fill) {
      Vector own, ghosted;
      own.reinit(owned, communicator);
      fill(own);
      own.compress(VectorOperation::insert);
      ghosted.reinit(owned, relevant, communicator);
      ghosted = own;
      return ghosted;
    };
    DataOut<dim> data;
    data.attach_dof_handler(dof_handler);
    const std::vector<
      DataComponentInterpretation::DataComponentInterpretation>
      vector_field(dim,
                   DataComponentInterpretation::component_is_part_of_vector);
    const Vector u = field([&](Vector &v) {
      for (const auto i : owned)
        v(i) = displacement(i);
    });
    data.add_data_vector(u,
                         std::vector<std::string>(dim, "displacement"),
                         DataOut<dim>::type_dof_data,
                         vector_field);

    // Two numbers per node ride on the first two components.
    std::vector<Vector> states;
    if (interface != nullptr)
      {
        const std::vector<PointReport> points = interface->report();
        states.push_back(field([&](Vector &v) {
          for (const PointReport &p : points)
            {
              v(p.node.unknowns[0]) = p.pressure;
              v(p.node.unknowns[1]) = p.damage;
            }
        }));
        states.push_back(field([&](Vector &v) {
          for (const PointReport &p : points)
            {
              v(p.node.unknowns[0]) = p.state;
              v(p.node.unknowns[1]) = std::min(p.gap, 1e3);
            }
        }));
        std::vector<std::string> names[2] = {{"contact_pressure", "damage"},
                                             {"interface_state", "gap"}};
        for (unsigned int k = 0; k < 2; ++k)
          {
            if (dim == 3)
              names[k].push_back(k == 0 ? "unused_1" : "unused_2");
            data.add_data_vector(states[k], names[k]);
          }
      }
    data.build_patches(dof_handler.get_fe().degree);

    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      std::filesystem::create_directories(output_folder + "/fields");
    MPI_Barrier(communicator);
    const std::string file =
      "fields/" + Utilities::int_to_string(records.size(), 4) + ".vtu";
    data.write_vtu_in_parallel(output_folder + "/" + file, communicator);
    records.emplace_back(time, file);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::ofstream pvd(output_folder + "/fields.pvd");
        DataOutBase::write_pvd_record(pvd, records);
      }
  }

  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace demold

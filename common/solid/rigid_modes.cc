// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid-body modes: the near null space that multigrid needs.
#include "solid/rigid_modes.h"

#include "base/plane_model.h"

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping_q1.h>

namespace demold
{
  using namespace dealii;

  template <int dim>
  std::vector<Vector> rigid_body_modes(const DoFHandler<dim, dim> &dof_handler,
                                       const Vector               &layout)
  {
    constexpr unsigned int n_modes = dim == 2 ? 3 : 6;
    std::vector<Vector>    modes(n_modes);
    const IndexSet         owned = layout.locally_owned_elements();
    for (Vector &mode : modes)
      mode.reinit(owned, layout.get_mpi_communicator());

    const auto                          &fe = dof_handler.get_fe();
    std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(indices);
          for (unsigned int i = 0; i < indices.size(); ++i)
            if (owned.is_element(indices[i]))
              {
                const unsigned int c = fe.system_to_component_index(i).first;
                const auto         X =
                  StaticMappingQ1<dim>::mapping.transform_unit_to_real_cell(
                    cell,
                    fe.unit_support_point(i));
                modes[c](indices[i]) = 1.;
                // rotation about axis a: e_a x X
                for (unsigned int a = (dim == 2 ? 2 : 0); a < 3; ++a)
                  {
                    const unsigned int b = (a + 1) % 3, d = (a + 2) % 3;
                    const double       value = c == b ? -X[d % dim] :
                                               c == d ? X[b % dim] :
                                                        0.;
                    modes[dim + (dim == 2 ? 0 : a)](indices[i]) = value;
                  }
              }
        }
    for (Vector &mode : modes)
      mode.compress(VectorOperation::insert);
    return modes;
  }

  template std::vector<Vector> rigid_body_modes<2>(const DoFHandler<2, 2> &,
                                                   const Vector &);
  template std::vector<Vector> rigid_body_modes<3>(const DoFHandler<3, 3> &,
                                                   const Vector &);
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// The mass of each unknown.
#include "solid/lumped_mass.h"

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

namespace demold
{
  using namespace dealii;

  template <int dim>
  Vector lumped_mass(const DoFHandler<dim, dim> &dof_handler,
                     const PlaneModel           &plane,
                     const double                density,
                     const Vector               &layout)
  {
    const auto       &fe = dof_handler.get_fe();
    const QGauss<dim> quadrature(fe.degree + 1);
    FEValues<dim>     fe_values(fe,
                            quadrature,
                            update_values | update_JxW_values |
                              update_quadrature_points);
    Vector            mass;
    mass.reinit(layout.locally_owned_elements(), layout.get_mpi_communicator());
    std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
    dealii::Vector<double>               local(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          fe_values.reinit(cell);
          local = 0.;
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const double m =
                density * fe_values.JxW(q) *
                plane_weight<dim>(plane, fe_values.quadrature_point(q));
              for (unsigned int i = 0; i < local.size(); ++i)
                local(i) += m * fe_values.shape_value(i, q);
            }
          cell->get_dof_indices(indices);
          mass.add(indices, local);
        }
    mass.compress(VectorOperation::add);
    return mass;
  }

  template Vector lumped_mass<2>(const DoFHandler<2, 2> &,
                                 const PlaneModel &,
                                 const double,
                                 const Vector &);
  template Vector lumped_mass<3>(const DoFHandler<3, 3> &,
                                 const PlaneModel &,
                                 const double,
                                 const Vector &);
} // namespace demold

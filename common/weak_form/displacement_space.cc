// SPDX-License-Identifier: LGPL-2.1-or-later
// The displacement unknowns of a distributed finite element mesh.
#include "weak_form/displacement_space.h"

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

namespace demold
{
  using namespace dealii;

  template <int dim>
  DisplacementSpace displacement_space(const DoFHandler<dim, dim> &dof_handler)
  {
    const MPI_Comm communicator = dof_handler.get_communicator();
    IndexSet       relevant;
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
    return {communicator,
            dof_handler.locally_owned_dofs(),
            relevant,
            [&dof_handler,
             communicator](DynamicSparsityPattern          &pattern,
                           const AffineConstraints<double> &constraints) {
              DoFTools::make_sparsity_pattern(dof_handler,
                                              pattern,
                                              constraints,
                                              false,
                                              Utilities::MPI::this_mpi_process(
                                                communicator));
            }};
  }

  template DisplacementSpace displacement_space<2>(const DoFHandler<2, 2> &);
  template DisplacementSpace displacement_space<3>(const DoFHandler<3, 3> &);
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// The one vector and the one matrix type of the project.
#ifndef demold_weak_form_algebra_h
#define demold_weak_form_algebra_h

#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

namespace demold
{
  /// Distributed vector of all unknowns: displacements [mm], then the extra
  /// unknowns of the terms.
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /// Distributed matrix over the same unknowns.
  using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Element matrices into the rows of a sparse matrix, with few searches.
#ifndef demold_weak_form_matrix_inserter_h
#define demold_weak_form_matrix_inserter_h

#include "weak_form/algebra.h"

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace demold
{
  /// Adds dense matrices to a sparse one whose pattern has their entries. The
  /// rows of one node have the same pattern and the columns of one node lie
  /// side by side: where an entry was found once, the next ones need only be
  /// recognised. That takes half the time of a search per entry.
  class MatrixInserter
  {
  public:
    /// Adds @p factor * @p K to rows and columns @p indices. False, with
    /// nothing added, if a row is not of this rank or an entry not in the
    /// pattern.
    bool add(SparseMatrix                                       &matrix,
             const std::vector<dealii::types::global_dof_index> &indices,
             const dealii::FullMatrix<double>                   &K,
             double                                              factor);

  private:
    bool find(const int *columns, int n_columns);

    std::vector<int>      rows, wanted;  ///< local indices on this rank
    std::vector<int>      places;        ///< of the wanted columns in a row
    std::vector<int>      places_of_all; ///< the same for all rows
    std::vector<double *> values;        ///< of the rows
  };
} // namespace demold

#endif

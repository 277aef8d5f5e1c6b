// SPDX-License-Identifier: LGPL-2.1-or-later
// Element matrices into the rows of a sparse matrix, with few searches.
#include "weak_form/matrix_inserter.h"

#include <Epetra_CrsMatrix.h>

#include <algorithm>

namespace demold
{
  using namespace dealii;

  /// Fills `places`, which hold those of the row before, for a row with these
  /// sorted @p columns.
  bool MatrixInserter::find(const int *columns, const int n_columns)
  {
    for (std::size_t j = 0; j < wanted.size(); ++j)
      {
        int &place = places[j];
        if (place < n_columns && columns[place] == wanted[j])
          continue;
        place = j > 0 ? places[j - 1] + 1 : 0;
        if (place < n_columns && columns[place] == wanted[j])
          continue;
        place =
          std::lower_bound(columns, columns + n_columns, wanted[j]) - columns;
        if (place == n_columns || columns[place] != wanted[j])
          return false;
      }
    return true;
  }

  bool MatrixInserter::add(SparseMatrix                               &matrix,
                           const std::vector<types::global_dof_index> &indices,
                           const FullMatrix<double>                   &K,
                           const double                                factor)
  {
    const Epetra_CrsMatrix &A = matrix.trilinos_matrix();
    const std::size_t       n = indices.size();
    rows.resize(n);
    wanted.resize(n);
    places.assign(n, 0);
    places_of_all.resize(n * n);
    values.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      {
        const int index = static_cast<int>(indices[i]);
        rows[i]         = A.RowMap().LID(index);
        wanted[i]       = A.ColMap().LID(index);
        if (rows[i] < 0 || wanted[i] < 0)
          return false;
      }
    for (std::size_t i = 0; i < n; ++i)
      {
        int  n_columns = 0;
        int *columns   = nullptr;
        A.ExtractMyRowView(rows[i], n_columns, values[i], columns);
        if (!find(columns, n_columns))
          return false;
        std::copy(places.begin(), places.end(), &places_of_all[i * n]);
      }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        values[i][places_of_all[i * n + j]] += factor * K(i, j);
    return true;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows of the assembled system that a term turns into others.
#include "weak_form/condensed_rows.h"

#include <deal.II/lac/affine_constraints.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>

namespace demold
{
  using namespace dealii;

  CondensedRows::CondensedRows(const AffineConstraints<double> &constraints,
                               Vector                          &residual,
                               Vector                          &forces,
                               Vector                          &lift,
                               SparseMatrix                    *matrix)
    : constraints(constraints)
    , residual(residual)
    , forces(forces)
    , lift(lift)
    , matrix(matrix)
  {}

  CondensedRows::Row
  CondensedRows::row_of(const types::global_dof_index i) const
  {
    const Epetra_CrsMatrix &A      = matrix->trilinos_matrix();
    const int               number = static_cast<int>(i);
    int                     n      = A.NumGlobalEntries(number);
    Row                     row{std::vector<int>(n), std::vector<double>(n)};
    const int               error = A.ExtractGlobalRowCopy(number,
                                             n,
                                             n,
                                             row.values.data(),
                                             row.columns.data());
    AssertThrow(error == 0, ExcTrilinosError(error));
    return row;
  }

  void CondensedRows::write(const types::global_dof_index i, const Row &row)
  {
    auto     &A = const_cast<Epetra_CrsMatrix &>(matrix->trilinos_matrix());
    const int error =
      A.ReplaceGlobalValues(static_cast<int>(i),
                            static_cast<int>(row.columns.size()),
                            row.values.data(),
                            row.columns.data());
    AssertThrow(error == 0, ExcTrilinosError(error));
  }

  void CondensedRows::replace(const Indices                &rows,
                              const dealii::Vector<double> &new_residual,
                              const FullMatrix<double>     &T,
                              const Indices                &columns,
                              const FullMatrix<double>     &more)
  {
    const unsigned int n = rows.size();
    for (unsigned int a = 0; a < n; ++a)
      residual(rows[a]) = new_residual(a);
    if (!with_tangent())
      return;

    std::vector<Row>    old;
    std::vector<double> old_lift;
    for (const auto i : rows)
      {
        old.push_back(row_of(i));
        old_lift.push_back(lift(i));
      }
    for (unsigned int a = 0; a < n; ++a)
      {
        Row row = old[a]; // all rows of a node have the same columns
        std::fill(row.values.begin(), row.values.end(), 0.);
        double     moved = 0.;
        const auto add   = [&](const int column, const double value) {
          const auto found =
            std::find(row.columns.begin(), row.columns.end(), column);
          Assert(found != row.columns.end(), ExcInternalError());
          row.values[found - row.columns.begin()] += value;
        };
        for (unsigned int b = 0; b < n; ++b)
          {
            moved += T(a, b) * old_lift[b];
            for (std::size_t k = 0; k < old[b].columns.size(); ++k)
              if (T(a, b) * old[b].values[k] != 0.)
                add(old[b].columns[k], T(a, b) * old[b].values[k]);
          }
        for (unsigned int j = 0; j < columns.size(); ++j)
          if (!constraints.is_constrained(columns[j]))
            add(static_cast<int>(columns[j]), more(a, j));
          else
            moved -= more(a, j) * constraints.get_inhomogeneity(columns[j]);
        write(rows[a], row);
        lift(rows[a]) = moved;
      }
  }
} // namespace demold

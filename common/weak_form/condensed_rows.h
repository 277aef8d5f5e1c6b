// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows of the assembled system that a term turns into others.
#ifndef demold_weak_form_condensed_rows_h
#define demold_weak_form_condensed_rows_h

#include "weak_form/algebra.h"

#include <deal.II/base/types.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace dealii
{
  template <typename number>
  class AffineConstraints;
}

namespace demold
{
  /// The system after all terms have added to it, open for replacing rows:
  /// what a term needs that eliminates unknowns of its own by rows of others.
  class CondensedRows
  {
  public:
    using Indices = std::vector<dealii::types::global_dof_index>;

    /// @p matrix may be null: residual only. @p lift holds what the prescribed
    /// increments have moved to the right hand side, @p forces those of the
    /// interfaces.
    CondensedRows(const dealii::AffineConstraints<double> &constraints,
                  Vector                                  &residual,
                  Vector                                  &forces,
                  Vector                                  &lift,
                  SparseMatrix                            *matrix);

    bool with_tangent() const
    {
      return matrix != nullptr;
    }

    /// Residual [N] of an unknown of this rank.
    double residual_of(const dealii::types::global_dof_index i) const
    {
      return residual(i);
    }

    /// [N] what prescribed increments have moved to the right hand side.
    double lift_of(const dealii::types::global_dof_index i) const
    {
      return lift(i);
    }

    /// One row of the matrix, as it stands.
    struct Row
    {
      std::vector<int>    columns;
      std::vector<double> values;
    };

    Row row_of(const dealii::types::global_dof_index i) const;

    /// Tells of a force [N] that has balanced row @p i without entering it.
    void add_force(const dealii::types::global_dof_index i, const double force)
    {
      forces(i) += force;
    }

    /// Replaces the residual of the unknowns @p rows of this rank by
    /// @p new_residual, and where there is a matrix the linear rows K by
    /// T K + @p more, whose columns are @p columns.
    void replace(const Indices                    &rows,
                 const dealii::Vector<double>     &new_residual,
                 const dealii::FullMatrix<double> &T,
                 const Indices                    &columns,
                 const dealii::FullMatrix<double> &more);

  private:
    void write(const dealii::types::global_dof_index i, const Row &row);

    const dealii::AffineConstraints<double> &constraints;
    Vector                                  &residual;
    Vector                                  &forces;
    Vector                                  &lift;
    SparseMatrix                            *matrix;
  };
} // namespace demold

#endif

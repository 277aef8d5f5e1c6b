// SPDX-License-Identifier: LGPL-2.1-or-later
// Smoothed-aggregation multigrid (ML) that knows the rigid-body modes.
#include "solution/multigrid.h"

#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Takes the columns of unknowns whose own row holds nothing but its
    /// diagonal out of the other rows, as a support would have done. The
    /// smoother and its eigenvalues want a matrix close to symmetric.
    void decouple_fixed_unknowns(SparseMatrix &matrix)
    {
      auto      &A = const_cast<Epetra_CrsMatrix &>(matrix.trilinos_matrix());
      int        n = 0, *columns = nullptr;
      double    *values      = nullptr;
      const auto is_diagonal = [&](const int row, const int entry) {
        return A.GCID(columns[entry]) == A.GRID(row);
      };

      Epetra_Vector fixed(A.RowMap());
      for (int row = 0; row < A.NumMyRows(); ++row)
        {
          A.ExtractMyRowView(row, n, values, columns);
          double diagonal = 0., rest = 0.;
          for (int k = 0; k < n; ++k)
            (is_diagonal(row, k) ? diagonal : rest) += std::abs(values[k]);
          fixed[row] = rest <= 1e-12 * diagonal ? 1. : 0.;
        }

      Epetra_Vector fixed_column(A.ColMap());
      if (A.Importer() != nullptr)
        fixed_column.Import(fixed, *A.Importer(), Insert);
      else
        fixed_column = fixed;
      for (int row = 0; row < A.NumMyRows(); ++row)
        {
          A.ExtractMyRowView(row, n, values, columns);
          for (int k = 0; k < n; ++k)
            if (fixed_column[columns[k]] != 0. && !is_diagonal(row, k))
              values[k] = 0.;
        }
    }
  } // namespace

  void Multigrid::set_rigid_body_modes(const std::vector<Vector> &modes,
                                       const unsigned int n_components_per_node)
  {
    clear();
    n_modes      = modes.size();
    n_components = n_components_per_node;
    null_space.clear();
    for (const Vector &mode : modes)
      null_space.insert(null_space.end(), mode.begin(), mode.end());
  }


  bool Multigrid::has_modes() const
  {
    return n_modes > 0;
  }


  bool Multigrid::build(const SparseMatrix &matrix)
  {
    // First the hierarchy, which points into the matrix.
    clear();
    kept_matrix.copy_from(matrix);
    decouple_fixed_unknowns(kept_matrix);

    Teuchos::ParameterList list;
    ML_Epetra::SetDefaults("SA", list);
    list.set("ML output", 0);
    list.set("PDE equations", static_cast<int>(n_components));
    if (has_modes())
      {
        AssertThrow(null_space.size() ==
                      n_modes * matrix.trilinos_matrix().NumMyRows(),
                    ExcMessage("The modes and the matrix differ in their "
                               "number of rows."));
        list.set("null space: type", "pre-computed");
        list.set("null space: dimension", static_cast<int>(n_modes));
        list.set("null space: vectors", null_space.data());
      }
    list.set("aggregation: type", "Uncoupled");
    list.set("smoother: type", "Chebyshev");
    // On a body of its own one is as fast; where a stiff penalty joins two
    // bodies, three need half the iterations and fewer hierarchies.
    list.set("smoother: sweeps", 3);
    list.set("smoother: pre or post", "both");
    list.set("coarse: type", "Amesos-KLU");
    // 5 iterations are enough, 4 treble the Krylov iterations.
    list.set("eigen-analysis: iterations", 8);
    // The eigenvalue estimates start from random vectors: always the same.
    list.set("initialize random seed", true);
    try
      {
        hierarchy.initialize(kept_matrix, list);
        built = true;
      }
    catch (const ExceptionBase &)
      {
        clear();
      }
    return built;
  }


  bool Multigrid::is_built() const
  {
    return built;
  }


  void Multigrid::clear()
  {
    hierarchy.clear();
    kept_matrix.clear();
    built = false;
  }


  void Multigrid::vmult(Vector &y, const Vector &x) const
  {
    hierarchy.vmult(y, x);
  }
} // namespace demold

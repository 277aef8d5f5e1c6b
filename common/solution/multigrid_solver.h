// SPDX-License-Identifier: LGPL-2.1-or-later
// Krylov method with multigrid, and when to renew the hierarchy.
#ifndef demold_solution_multigrid_solver_h
#define demold_solution_multigrid_solver_h

#include "solution/krylov.h"
#include "solution/linear_solver_parameters.h"
#include "solution/multigrid.h"

#include <vector>

namespace demold
{
  /// Conjugate gradients (GMRES if unsymmetric) with multigrid.
  ///
  /// An older hierarchy is kept as long as that pays: the iterations beyond
  /// what the first solution with it needed for the same residual are added up,
  /// and once they have cost as much as a new hierarchy, it is built. Counted
  /// in iterations, not in seconds, so that runs repeat exactly.
  class MultigridSolver
  {
  public:
    /// @param statistics  where to book; must live as long as this
    MultigridSolver(const LinearSolverParameters &parameters,
                    LinearSolverStatistics       &statistics);

    Multigrid multigrid;

    /// Solves A x = b as LinearSolver does; false if it could not.
    bool solve(const SparseMatrix &A,
               Vector             &x,
               const Vector       &b,
               double              tolerance,
               bool                symmetric);

    void forget();

  private:
    bool         build(const SparseMatrix &A);
    bool         iterate(const SparseMatrix &A,
                         Vector             &x,
                         const Vector       &b,
                         double              tolerance,
                         bool                symmetric);
    void         compare_with_first(const std::vector<double> &residuals);
    unsigned int max_iterations(double tolerance) const;

    const LinearSolverParameters parameters;
    LinearSolverStatistics      &statistics;
    bool                fresh = false;   // hierarchy built for this very matrix
    std::vector<double> first_residuals; // by iteration, when it was new
    unsigned int        excess_iterations = 0; // since then
    unsigned int        pause             = 0;
  };
} // namespace demold

#endif

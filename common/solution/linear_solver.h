// SPDX-License-Identifier: LGPL-2.1-or-later
// The linear solver behind every strategy: direct or multigrid, kept or new.
#ifndef demold_solution_linear_solver_h
#define demold_solution_linear_solver_h

#include "solution/linear_solver_parameters.h"
#include "weak_form/algebra.h"

#include <deal.II/base/mpi.h>

#include <memory>
#include <vector>

namespace demold
{
  /// Solves A x = b. Direct is MUMPS; iterative is conjugate gradients (GMRES
  /// if unsymmetric) with multigrid, which falls back to MUMPS where it fails.
  /// A hierarchy is kept as long as that pays, see MultigridSolver. A kept
  /// factor is the preconditioner of at most 8 GMRES iterations. No decision
  /// depends on clock time, so that runs repeat exactly.
  class LinearSolver
  {
  public:
    enum class Outcome
    {
      solved,
      inaccurate, ///< residual above the tolerance, or b not a number
      singular    ///< x = 0
    };

    LinearSolver(const LinearSolverParameters &parameters,
                 MPI_Comm                      communicator);
    ~LinearSolver();

    /// Displacements of all nodes [any unit] as rigid body: translations,
    /// rotations; laid out as the rows of the matrices to come, the
    /// @p n_components unknowns of a node consecutive. `auto` solves directly
    /// as long as there are none.
    void set_rigid_body_modes(const std::vector<Vector> &modes,
                              unsigned int               n_components);

    /// Solves A x = b until |b - A x| <= tolerance |b|, starting from x = 0.
    /// @param tolerance  [-], taken as `relative tolerance` if above that
    /// @param symmetric  A is symmetric in value, not necessarily definite
    /// @param has_extra_rows  A has multiplier rows behind the displacements,
    /// so that multigrid does not apply: solved directly
    Outcome solve(const SparseMatrix &A,
                  Vector             &x,
                  const Vector       &b,
                  double              tolerance,
                  bool                symmetric,
                  bool                has_extra_rows);

    /// Solves A x = b with the A of the last solve(), whose values are the same
    /// since then: its factor, or the hierarchy at hand, serves again.
    Outcome solve_again(const SparseMatrix &A,
                        Vector             &x,
                        const Vector       &b,
                        double              tolerance);

    /// Drops factor and hierarchy, so that what follows does not depend on
    /// what came before: at checkpoints, or when the pattern has changed.
    void forget();

    const LinearSolverStatistics &statistics() const;

    /// Goes on counting from those of @p statistics: after a restart.
    void continue_from(const LinearSolverStatistics &statistics);

    /// Number of negative eigenvalues of the A solved last; -1 if unknown:
    /// unsymmetric, solved iteratively or with an older factor.
    int n_negative_pivots() const;

    /// Sign of det A of the A solved last; 0 if unknown or A is singular.
    int determinant_sign() const;

    /// Memory of the last factorisation, all ranks together [MiB].
    double factor_memory() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace demold

#endif

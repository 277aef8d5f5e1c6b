// SPDX-License-Identifier: LGPL-2.1-or-later
// The linear solver behind every strategy: direct or multigrid, kept or new.
#include "solution/linear_solver.h"

#include "solution/krylov.h"
#include "solution/multigrid_solver.h"
#include "solution/mumps.h"

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Beyond this a new factor is cheaper than a kept one.
    constexpr unsigned int kept_factor_iterations = 8;
  } // namespace


  struct LinearSolver::Implementation
  {
    Implementation(const LinearSolverParameters &parameters,
                   const MPI_Comm                communicator)
      : parameters(parameters)
      , communicator(communicator)
      , multigrid_solver(parameters, statistics)
    {}

    Outcome solve(const SparseMatrix &, Vector &, const Vector &, double);
    bool
    try_kept_factor(const SparseMatrix &, Vector &, const Vector &, double);
    Outcome
    solve_directly(const SparseMatrix &, Vector &, const Vector &, double);
    Mumps::Status factorise(const SparseMatrix &);
    Outcome substitute(const SparseMatrix &, Vector &, const Vector &, double);
    void    forget();

    const LinearSolverParameters parameters;
    const MPI_Comm               communicator;
    LinearSolverStatistics       statistics;
    MultigridSolver              multigrid_solver;

    unsigned int iterative_above = parameters.iterative_above;
    bool         symmetric       = false;
    bool         has_extra_rows  = false;
    unsigned int n_rows          = 0; // of the kept factor and hierarchy

    std::unique_ptr<Mumps> mumps;
    bool                   has_factor     = false;
    bool                   factor_is_of_A = false;
  };


  LinearSolver::Outcome
  LinearSolver::Implementation::solve(const SparseMatrix &A,
                                      Vector             &x,
                                      const Vector       &b,
                                      const double        tolerance)
  {
    const double setup = statistics.seconds_setup;
    const Timer  timer;
    ++statistics.solves;

    const double goal = std::min(tolerance, parameters.relative_tolerance);
    const bool   iterative =
      !has_extra_rows && parameters.linear != "direct" &&
      (parameters.linear == "iterative" ||
       (A.m() > iterative_above && multigrid_solver.multigrid.has_modes()));
    Outcome      outcome = Outcome::solved;
    const double load    = b.l2_norm();
    if (load == 0. || !std::isfinite(load))
      {
        x       = 0.;
        outcome = load == 0. ? Outcome::solved : Outcome::inaccurate;
      }
    else if (factor_is_of_A)
      outcome = substitute(A, x, b, goal);
    else if (!iterative || !multigrid_solver.solve(A, x, b, goal, symmetric))
      outcome = solve_directly(A, x, b, goal);
    statistics.seconds_solve +=
      timer.wall_time() - (statistics.seconds_setup - setup);
    return outcome;
  }


  bool LinearSolver::Implementation::try_kept_factor(const SparseMatrix &A,
                                                     Vector             &x,
                                                     const Vector       &b,
                                                     const double tolerance)
  {
    if (!has_factor || !parameters.reuse_factor)
      return false;
    const KrylovReport report =
      gmres(A,
            x,
            b,
            {[this](Vector &y, const Vector &r) { mumps->solve(y, r); }},
            {tolerance, kept_factor_iterations});
    statistics.krylov_iterations += report.iterations;
    return report.end == KrylovReport::End::converged;
  }


  LinearSolver::Outcome
  LinearSolver::Implementation::solve_directly(const SparseMatrix &A,
                                               Vector             &x,
                                               const Vector       &b,
                                               const double        tolerance)
  {
    if (try_kept_factor(A, x, b, tolerance))
      return Outcome::solved;
    const Mumps::Status status = factorise(A);
    if (status == Mumps::Status::singular)
      {
        x = 0.;
        return Outcome::singular;
      }
    AssertThrow(status == Mumps::Status::ok,
                ExcMessage(
                  "MUMPS could not factorise a matrix of " +
                  std::to_string(A.m()) +
                  " rows, INFOG(1) = " + std::to_string(mumps->error_code()) +
                  (status == Mumps::Status::out_of_memory ?
                     ", for want of memory. Try Solver/linear = iterative." :
                     ".")));
    return substitute(A, x, b, tolerance);
  }


  Mumps::Status LinearSolver::Implementation::factorise(const SparseMatrix &A)
  {
    const Timer timer;
    if (!mumps)
      mumps = std::make_unique<Mumps>(communicator, symmetric);
    const Mumps::Status status = mumps->analyse_and_factorise(A);
    has_factor = factor_is_of_A = (status == Mumps::Status::ok);
    ++statistics.factorisations;
    statistics.seconds_setup += timer.wall_time();
    return status;
  }


  /// With the factor of A itself, refined where round-off asks for it.
  LinearSolver::Outcome
  LinearSolver::Implementation::substitute(const SparseMatrix &A,
                                           Vector             &x,
                                           const Vector       &b,
                                           const double        tolerance)
  {
    mumps->solve(x, b);
    Vector       residual(b);
    Vector       correction(b);
    const double goal = tolerance * b.l2_norm();
    double       last = 1e300;
    for (unsigned int step = 0; true; ++step)
      {
        const double norm = A.residual(residual, x, b);
        if (norm <= goal)
          return Outcome::solved;
        if (!(norm < .5 * last) || step == 3)
          break;
        last = norm;
        mumps->solve(correction, residual);
        x += correction;
      }
    // What round-off leaves of the residual, however good the factor.
    const double floor = 1e-14 * std::sqrt(static_cast<double>(A.m())) *
                         A.linfty_norm() * x.linfty_norm();
    return residual.l2_norm() <= floor ? Outcome::solved : Outcome::inaccurate;
  }


  void LinearSolver::Implementation::forget()
  {
    multigrid_solver.forget();
    mumps.reset();
    has_factor = factor_is_of_A = false;
  }


  LinearSolver::LinearSolver(const LinearSolverParameters &parameters,
                             const MPI_Comm                communicator)
    : implementation(std::make_unique<Implementation>(parameters, communicator))
  {
    parameters.check();
  }


  LinearSolver::~LinearSolver() = default;


  void LinearSolver::set_rigid_body_modes(const std::vector<Vector> &modes,
                                          const unsigned int n_components)
  {
    implementation->multigrid_solver.multigrid
      .set_rigid_body_modes(modes, n_components);
    // The factor of a plane mesh stays thin, that of a block does not.
    if (implementation->parameters.iterative_above == 0)
      implementation->iterative_above = n_components == 3 ? 8000 : 40000;
  }


  LinearSolver::Outcome LinearSolver::solve(const SparseMatrix &A,
                                            Vector             &x,
                                            const Vector       &b,
                                            const double        tolerance,
                                            const bool          symmetric,
                                            const bool          has_extra_rows)
  {
    Implementation &s = *implementation;
    if (s.n_rows != A.m())
      s.forget();
    s.n_rows = A.m();
    if (s.symmetric != symmetric)
      {
        s.mumps.reset();
        s.has_factor = false;
      }
    s.symmetric      = symmetric;
    s.has_extra_rows = has_extra_rows;
    s.factor_is_of_A = false;
    return s.solve(A, x, b, tolerance);
  }


  LinearSolver::Outcome LinearSolver::solve_again(const SparseMatrix &A,
                                                  Vector             &x,
                                                  const Vector       &b,
                                                  const double        tolerance)
  {
    AssertDimension(A.m(), implementation->n_rows);
    return implementation->solve(A, x, b, tolerance);
  }


  void LinearSolver::forget()
  {
    implementation->forget();
  }


  const LinearSolverStatistics &LinearSolver::statistics() const
  {
    return implementation->statistics;
  }


  void LinearSolver::continue_from(const LinearSolverStatistics &statistics)
  {
    implementation->statistics = statistics;
  }


  int LinearSolver::n_negative_pivots() const
  {
    const Implementation &s = *implementation;
    return s.factor_is_of_A ? s.mumps->n_negative_pivots() : -1;
  }


  int LinearSolver::determinant_sign() const
  {
    const Implementation &s = *implementation;
    return s.factor_is_of_A ? s.mumps->determinant_sign() : 0;
  }


  double LinearSolver::factor_memory() const
  {
    const Implementation &s = *implementation;
    return s.mumps ? s.mumps->memory() : 0.;
  }
} // namespace demold

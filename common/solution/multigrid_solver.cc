// SPDX-License-Identifier: LGPL-2.1-or-later
// Krylov method with multigrid, and when to renew the hierarchy.
#include "solution/multigrid_solver.h"

#include <deal.II/base/timer.h>

#include <algorithm>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Iterations that cost as much as a new hierarchy (24^3 elements: 43).
    constexpr unsigned int hierarchy_worth = 40;

    /// Direct solutions before multigrid is tried again after it failed.
    constexpr unsigned int pause_after_failure = 5;

    /// Iterations until a residual of @p tolerance, at most all of them.
    unsigned int iterations_to(const std::vector<double> &residuals,
                               const double               tolerance)
    {
      unsigned int i = 0;
      while (i + 1 < residuals.size() && residuals[i] > tolerance)
        ++i;
      return i;
    }
  } // namespace


  MultigridSolver::MultigridSolver(const LinearSolverParameters &parameters,
                                   LinearSolverStatistics       &statistics)
    : parameters(parameters)
    , statistics(statistics)
  {}


  bool MultigridSolver::solve(const SparseMatrix &A,
                              Vector             &x,
                              const Vector       &b,
                              const double        tolerance,
                              const bool          symmetric)
  {
    if (pause > 0)
      {
        --pause;
        return false;
      }
    fresh = false;
    if (multigrid.is_built() && parameters.reuse &&
        excess_iterations < hierarchy_worth &&
        iterate(A, x, b, tolerance, symmetric))
      return true;
    if (build(A) && iterate(A, x, b, tolerance, symmetric))
      return true;
    multigrid.clear();
    pause = pause_after_failure;
    return false;
  }


  bool MultigridSolver::build(const SparseMatrix &A)
  {
    const Timer timer;
    fresh             = multigrid.build(A);
    excess_iterations = 0;
    ++statistics.hierarchies;
    statistics.seconds_setup += timer.wall_time();
    return fresh;
  }


  bool MultigridSolver::iterate(const SparseMatrix &A,
                                Vector             &x,
                                const Vector       &b,
                                const double        tolerance,
                                const bool          symmetric)
  {
    const Preconditioner cycle{
      [this](Vector &y, const Vector &r) { multigrid.vmult(y, r); }};
    const KrylovLimits limits{tolerance, max_iterations(tolerance)};

    KrylovReport report;
    if (symmetric)
      {
        report = conjugate_gradients(A, x, b, cycle, limits);
        statistics.krylov_iterations += report.iterations;
      }
    // A kept hierarchy that breaks down is rather renewed.
    if (!symmetric || (fresh && report.end == KrylovReport::End::breakdown))
      {
        report = gmres(A, x, b, cycle, limits);
        statistics.krylov_iterations += report.iterations;
      }
    if (report.end != KrylovReport::End::converged)
      return false;

    if (fresh)
      first_residuals = report.residuals;
    else
      compare_with_first(report.residuals);
    return true;
  }


  /// Compares down to the residual that both have reached; beyond, where there
  /// is nothing to compare with, @p residuals are the first.
  void MultigridSolver::compare_with_first(const std::vector<double> &residuals)
  {
    const double both = std::max(residuals.back(), first_residuals.back());
    const unsigned int first = iterations_to(first_residuals, both);
    const unsigned int now   = iterations_to(residuals, both);
    excess_iterations += now > first ? now - first : 0;
    if (residuals.back() < first_residuals.back())
      {
        first_residuals.resize(first + 1);
        first_residuals.insert(first_residuals.end(),
                               residuals.begin() + now + 1,
                               residuals.end());
      }
  }


  /// With a kept hierarchy not more than a new one and its solution may cost.
  unsigned int MultigridSolver::max_iterations(const double tolerance) const
  {
    if (fresh || tolerance < first_residuals.back())
      return parameters.max_iterations;
    return std::min(parameters.max_iterations,
                    2 * iterations_to(first_residuals, tolerance) +
                      hierarchy_worth);
  }


  void MultigridSolver::forget()
  {
    multigrid.clear();
    pause = 0;
  }
} // namespace demold

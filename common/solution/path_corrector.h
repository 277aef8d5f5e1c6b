// SPDX-License-Identifier: LGPL-2.1-or-later
// Newton's method for a step along a path: unknowns and time together.
#ifndef demold_solution_path_corrector_h
#define demold_solution_path_corrector_h

#include "solution/nonlinear_solver.h"
#include "solution/residual_measure.h"
#include "weak_form/algebra.h"

namespace demold
{
  class PathConstraint;

  /// Solves R(u, t) = 0, c(u, t) = 0 from the accepted state. The load vector
  /// f = -dR/dt and w = dc/dt are differences of the residual and of c over
  /// the time `probe`, so that supports, mould, loads and rates enter alike;
  /// exact for motions linear in time, and in any case only the tangent is
  /// concerned. Iterations never freeze states as they do without a path: the
  /// constraint picks one of the branches.
  class PathCorrector
  {
  public:
    /// @p newton keeps seconds and the largest force of the run.
    PathCorrector(const NewtonParameters &parameters,
                  LinearSolver           &linear_solver,
                  NonlinearSolver        &newton);

    /// The trial of @p weak_form must be the accepted state.
    NewtonReport solve(WeakForm             &weak_form,
                       const PathConstraint &constraint,
                       const double          probe);

    /// Number that terms are told for iteration @p iteration.
    static unsigned int stage(const unsigned int iteration);

  private:
    /// Derivatives by the time.
    struct Rates
    {
      Vector f; ///< [N/s]
      double w; ///< per second
    };

    bool  assemble(WeakForm &, NewtonReport &);
    Rates differences(WeakForm &,
                      const PathConstraint &,
                      const Vector      &r,
                      const double       c,
                      const unsigned int iteration,
                      const double       probe);
    bool  correct(WeakForm &,
                  const PathConstraint &,
                  NewtonReport &,
                  const double probe);

    const NewtonParameters parameters;
    LinearSolver          &linear_solver;
    NonlinearSolver       &newton;
    ResidualMeasure        measure;
  };
} // namespace demold

#endif

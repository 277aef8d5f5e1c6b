// SPDX-License-Identifier: LGPL-2.1-or-later
// What every nonlinear solver takes, gives back and counts.
#ifndef demold_solution_nonlinear_solver_h
#define demold_solution_nonlinear_solver_h

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  class LinearSolver;
  class WeakForm;

  /// Entries of section Solver that belong to the nonlinear solver.
  struct NewtonParameters
  {
    std::string  nonlinear          = "newton"; ///< newton | kinsol
    unsigned int max_iterations     = 25;
    double       residual_tolerance = 1e-6;
    double       energy_tolerance   = 1e-10;
    bool         line_search        = false;

    void add_parameters(dealii::ParameterHandler &prm);
  };

  /// What one increment cost and how it went.
  struct NewtonReport
  {
    bool                      converged  = false;
    unsigned int              iterations = 0;
    std::vector<double>       residuals; ///< |R| / scale, one per assembly
    std::vector<unsigned int> state_changes;
    std::string               reason;     ///< why not, in words
    double                    force = 0.; ///< [N] largest of the solution
  };

  /// Solves R(u) = 0 from the trial of a weak form and leaves the solution
  /// there.
  class NonlinearSolver
  {
  public:
    virtual ~NonlinearSolver() = default;

    virtual NewtonReport solve(WeakForm &weak_form) = 0;

    /// Tells that the increment of @p report counts.
    void accept(const NewtonReport &report)
    {
      largest_force = std::max(largest_force, report.force);
    }

    /// Seconds spent in assembly, all increments.
    double seconds_assembly = 0.;

    /// Largest force norm [N] of an accepted increment; part of a checkpoint.
    double largest_force = 0.;
  };

  /// The solver named in @p parameters.
  std::unique_ptr<NonlinearSolver>
  make_nonlinear_solver(const NewtonParameters &parameters,
                        LinearSolver           &linear_solver);
} // namespace demold

#endif

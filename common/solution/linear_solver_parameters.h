// SPDX-License-Identifier: LGPL-2.1-or-later
// What the linear solver is asked for, and what it has done.
#ifndef demold_solution_linear_solver_parameters_h
#define demold_solution_linear_solver_parameters_h

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Entries of section Solver that belong to the linear solver.
  struct LinearSolverParameters
  {
    std::string  linear             = "auto"; ///< auto, direct, iterative
    unsigned int iterative_above    = 0;      ///< unknowns, for auto
    double       relative_tolerance = 1e-2;   ///< [-]
    bool         reuse              = true;
    bool         reuse_factor       = false;
    unsigned int max_iterations     = 500;

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;
  };

  /// What was done since the start of the run.
  struct LinearSolverStatistics
  {
    unsigned int factorisations    = 0;
    unsigned int hierarchies       = 0;
    unsigned int solves            = 0;
    unsigned int krylov_iterations = 0;
    double       seconds_setup     = 0.; ///< factors and hierarchies [s]
    double       seconds_solve     = 0.; ///< the rest [s]

    /// The counts, without the seconds, for checkpoints.
    std::vector<double> counts() const;
    static LinearSolverStatistics
    from_counts(const std::vector<double> &counts);
  };
} // namespace demold

#endif

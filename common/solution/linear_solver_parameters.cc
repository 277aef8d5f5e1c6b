// SPDX-License-Identifier: LGPL-2.1-or-later
// What the linear solver is asked for, and what it has done.
#include "solution/linear_solver_parameters.h"

#include "base/parameter_error.h"

#include <deal.II/base/parameter_handler.h>

namespace demold
{
  using namespace dealii;

  void LinearSolverParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("linear",
                      linear,
                      "linear solver: MUMPS, multigrid, or by number of "
                      "unknowns",
                      Patterns::Selection("auto|direct|iterative"));
    prm.add_parameter("iterative above",
                      iterative_above,
                      "number of unknowns from which auto is iterative; 0: "
                      "8000 in three dimensions, 40000 in two [-]",
                      Patterns::Integer(0));
    prm.add_parameter("relative tolerance",
                      relative_tolerance,
                      "loosest residual of a linear solution over its right-"
                      "hand side; Newton asks for less where it pays [-]",
                      Patterns::Double(1e-14, .5));
    prm.add_parameter("reuse",
                      reuse,
                      "keep a multigrid hierarchy as long as that pays");
    prm.add_parameter("reuse factor",
                      reuse_factor,
                      "try the last factor as preconditioner before a new one");
    prm.add_parameter("max linear iterations",
                      max_iterations,
                      "iterations before multigrid is given up for MUMPS [-]",
                      Patterns::Integer(1, 10000));
  }


  void LinearSolverParameters::check() const
  {
    if (linear != "auto" && linear != "direct" && linear != "iterative")
      throw ExcParameter("Solver/linear",
                         "must be auto, direct or iterative; got " + linear +
                           ".");
    if (!(relative_tolerance > 0. && relative_tolerance < 1.))
      throw ExcParameter("Solver/relative tolerance",
                         "must lie between 0 and 1; got " +
                           std::to_string(relative_tolerance) + ".");
  }


  std::vector<double> LinearSolverStatistics::counts() const
  {
    return {static_cast<double>(factorisations),
            static_cast<double>(hierarchies),
            static_cast<double>(solves),
            static_cast<double>(krylov_iterations)};
  }


  LinearSolverStatistics
  LinearSolverStatistics::from_counts(const std::vector<double> &counts)
  {
    LinearSolverStatistics statistics;
    statistics.factorisations    = static_cast<unsigned int>(counts.at(0));
    statistics.hierarchies       = static_cast<unsigned int>(counts.at(1));
    statistics.solves            = static_cast<unsigned int>(counts.at(2));
    statistics.krylov_iterations = static_cast<unsigned int>(counts.at(3));
    return statistics;
  }
} // namespace demold

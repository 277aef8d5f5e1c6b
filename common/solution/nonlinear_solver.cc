// SPDX-License-Identifier: LGPL-2.1-or-later
// What every nonlinear solver takes, gives back and counts.
#include "solution/nonlinear_solver.h"

#include "solution/kinsol.h"
#include "solution/newton.h"

#include <deal.II/base/parameter_handler.h>

namespace demold
{
  using namespace dealii;

  void NewtonParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("nonlinear",
                      nonlinear,
                      "newton: a new tangent in every iteration; kinsol: "
                      "SUNDIALS with a line search and tangents that are kept "
                      "for some iterations",
                      Patterns::Selection("newton|kinsol"));
    prm.add_parameter("max iterations",
                      max_iterations,
                      "iterations after which an increment is cut [-]",
                      Patterns::Integer(1, 1000));
    prm.add_parameter("residual tolerance",
                      residual_tolerance,
                      "unbalanced force over the largest of bulk, interface "
                      "and inertia force [-]",
                      Patterns::Double(1e-14, 1e-1));
    prm.add_parameter("energy tolerance",
                      energy_tolerance,
                      "work of the last correction over that of the largest "
                      "one [-]",
                      Patterns::Double(1e-20, 1.));
    prm.add_parameter("line search",
                      line_search,
                      "halve corrections that do not reduce the residual");
  }

  std::unique_ptr<NonlinearSolver>
  make_nonlinear_solver(const NewtonParameters &parameters,
                        LinearSolver           &linear_solver)
  {
    if (parameters.nonlinear == "kinsol")
      return std::make_unique<Kinsol>(parameters, linear_solver);
    return std::make_unique<Newton>(parameters, linear_solver);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// SUNDIALS' nonlinear solver on a weak form, as an alternative to Newton.
#include "solution/kinsol.h"

#include "solution/linear_solver.h"
#include "weak_form/weak_form.h"

#include <deal.II/base/timer.h>

#include <deal.II/sundials/kinsol.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int iterations_per_tangent = 10;
    constexpr double       linear_tolerance       = 1e-6;
  } // namespace

  Kinsol::Kinsol(const NewtonParameters &parameters,
                 LinearSolver           &linear_solver)
    : parameters(parameters)
    , linear_solver(linear_solver)
  {}

  bool Kinsol::assemble(WeakForm     &weak_form,
                        const bool    with_tangent,
                        NewtonReport &report)
  {
    const Timer timer;
    const bool admissible = weak_form.assemble(with_tangent, report.iterations);
    seconds_assembly += timer.wall_time();
    if (pattern_number != weak_form.pattern_number())
      {
        linear_solver.forget();
        tangent = Tangent::lost;
      }
    pattern_number = weak_form.pattern_number();
    if (with_tangent)
      {
        tangent = Tangent::fresh;
        ++n_tangents;
      }
    const ResidualNorms norms = weak_form.residual_norms();
    scale = std::max({norms.scale, 1e-4 * largest_force, 1e-300});
    report.residuals.push_back(norms.free / scale);
    report.state_changes.push_back(weak_form.n_state_changes());
    return admissible && std::isfinite(norms.free);
  }

  bool Kinsol::correct(WeakForm     &weak_form,
                       Vector       &correction,
                       const Vector &right_hand_side,
                       NewtonReport &report)
  {
    // KINSOL cannot know that the tangent it counts on is gone.
    if (tangent == Tangent::lost && !assemble(weak_form, true, report))
      return false;
    ++report.iterations;
    correction         = 0.;
    const auto outcome = tangent == Tangent::used ?
                           linear_solver.solve_again(weak_form.matrix,
                                                     correction,
                                                     right_hand_side,
                                                     linear_tolerance) :
                           linear_solver.solve(weak_form.matrix,
                                               correction,
                                               right_hand_side,
                                               linear_tolerance,
                                               weak_form.symmetric(),
                                               weak_form.has_extra_unknowns());
    tangent            = Tangent::used;
    return outcome != LinearSolver::Outcome::singular;
  }

  bool Kinsol::first_step(WeakForm &weak_form, NewtonReport &report)
  {
    if (!assemble(weak_form, true, report))
      return false;
    Vector       correction = weak_form.new_vector();
    const Vector right_hand_side(weak_form.right_hand_side);
    if (!correct(weak_form, correction, right_hand_side, report))
      return false;
    weak_form.update(correction, 1.);
    return assemble(weak_form, false, report);
  }

  NewtonReport Kinsol::solve(WeakForm &weak_form)
  {
    NewtonReport report;
    if (!first_step(weak_form, report))
      {
        report.reason = "the first step ended in an inadmissible state";
        return report;
      }
    using Solver = SUNDIALS::KINSOL<Vector>;
    Solver::AdditionalData options;
    options.strategy                      = Solver::AdditionalData::linesearch;
    options.maximum_non_linear_iterations = parameters.max_iterations;
    options.function_tolerance  = parameters.residual_tolerance * scale;
    options.step_tolerance      = 1e-14;
    options.maximum_setup_calls = iterations_per_tangent;

    Solver kinsol(options);
    kinsol.reinit_vector = [&](Vector &v) { v = weak_form.new_vector(); };
    kinsol.residual      = [&](const Vector &u, Vector &residual) {
      weak_form.trial = u;
      // 1: KINSOL may try a shorter step
      if (!assemble(weak_form, false, report))
        return 1;
      residual = weak_form.right_hand_side;
      residual *= -1.;
      return 0;
    };
    kinsol.setup_jacobian = [&](const Vector &u, const Vector &) {
      weak_form.trial = u;
      return assemble(weak_form, true, report) ? 0 : 1;
    };
    kinsol.solve_with_jacobian =
      [&](const Vector &rhs, Vector &solution, const double) {
        return correct(weak_form, solution, rhs, report) ? 0 : 1;
      };
    Vector u(weak_form.trial);
    try
      {
        kinsol.solve(u);
      }
    catch (const ExceptionBase &)
      {
        report.reason = "KINSOL found no solution within " +
                        std::to_string(parameters.max_iterations) +
                        " iterations";
        return report;
      }
    weak_form.trial = u;
    report.converged =
      assemble(weak_form, false, report) && weak_form.has_settled() &&
      report.residuals.back() <= 10. * parameters.residual_tolerance;
    if (report.converged)
      report.force = weak_form.residual_norms().scale;
    else
      report.reason = "KINSOL stopped short of the tolerance";
    return report;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Newton's method for a step along a path: unknowns and time together.
#include "solution/path_corrector.h"

#include "solution/bordered_system.h"
#include "solution/path_constraint.h"
#include "weak_form/weak_form.h"

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Terms freeze states in later iterations than this.
    constexpr unsigned int last_free_stage = 8;
  } // namespace

  PathCorrector::PathCorrector(const NewtonParameters &parameters,
                               LinearSolver           &linear_solver,
                               NonlinearSolver        &newton)
    : parameters(parameters)
    , linear_solver(linear_solver)
    , newton(newton)
  {}

  unsigned int PathCorrector::stage(const unsigned int iteration)
  {
    return std::min(iteration, last_free_stage);
  }

  bool PathCorrector::assemble(WeakForm &weak_form, NewtonReport &report)
  {
    const Timer        timer;
    const unsigned int pattern = weak_form.pattern_number();
    const bool admissible = weak_form.assemble(true, stage(report.iterations));
    if (pattern != weak_form.pattern_number())
      linear_solver.forget();
    newton.seconds_assembly += timer.wall_time();
    report.residuals.push_back(measure(weak_form, newton.largest_force, true));
    report.state_changes.push_back(weak_form.n_state_changes());
    if (!admissible)
      report.reason = "an element turned inside out";
    else if (!std::isfinite(report.residuals.back()))
      report.reason = "the residual is not a number";
    return report.reason.empty();
  }

  PathCorrector::Rates
  PathCorrector::differences(WeakForm             &weak_form,
                             const PathConstraint &constraint,
                             const Vector         &r,
                             const double          c,
                             const unsigned int    iteration,
                             const double          probe)
  {
    const Timer  timer;
    const double time = weak_form.trial_time();
    weak_form.move_to(time + probe);
    weak_form.assemble(false, stage(iteration));
    Rates rates = {weak_form.right_hand_side,
                   (constraint.value(weak_form, iteration) - c) / probe};
    rates.f -= r;
    rates.f /= probe;
    weak_form.move_to(time);
    newton.seconds_assembly += timer.wall_time();
    return rates;
  }

  /// One correction of unknowns and time.
  bool PathCorrector::correct(WeakForm             &weak_form,
                              const PathConstraint &constraint,
                              NewtonReport         &report,
                              const double          probe)
  {
    const unsigned int iteration = report.iterations;
    const Vector       r         = weak_form.right_hand_side;
    const double       c         = constraint.value(weak_form, iteration);
    Vector             h         = weak_form.new_vector();
    constraint.add_gradient(weak_form, iteration, h);
    weak_form.set_supports_to_zero(h);
    const Rates rates =
      differences(weak_form, constraint, r, c, iteration, probe);
    const BorderedSolution step =
      solve_bordered({weak_form.matrix, rates.f, h, rates.w, r, c},
                     linear_solver,
                     weak_form.symmetric(),
                     weak_form.has_extra_unknowns());
    ++report.iterations;
    if (!step.solved)
      {
        report.reason = "the bordered tangent is singular";
        return false;
      }
    weak_form.move_to(weak_form.trial_time() + step.dt);
    weak_form.update(step.du, 1.);
    return true;
  }

  NewtonReport PathCorrector::solve(WeakForm             &weak_form,
                                    const PathConstraint &constraint,
                                    const double          probe)
  {
    NewtonReport report;
    measure = ResidualMeasure();
    while (assemble(weak_form, report))
      {
        if (report.iterations > 0 &&
            report.residuals.back() <= parameters.residual_tolerance &&
            std::abs(constraint.value(weak_form, report.iterations)) <=
              constraint.tolerance() &&
            weak_form.has_settled())
          {
            report.converged = true;
            report.force     = weak_form.residual_norms().scale;
            return report;
          }
        if (report.iterations >= parameters.max_iterations)
          report.reason = "no convergence in " +
                          std::to_string(report.iterations) + " iterations";
        else if (report.residuals.size() > 3 && report.residuals.back() > 1e8)
          report.reason = "the residual grows without bound";
        if (!report.reason.empty() ||
            !correct(weak_form, constraint, report, probe))
          return report;
      }
    return report;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Newton's method on a weak form; it knows no mechanics.
#include "solution/newton.h"

#include "solution/linear_solver.h"
#include "weak_form/weak_form.h"

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// After this many iterations some state may flicker between two branches
    /// that both satisfy the residual: the work criterion is then given up.
    constexpr unsigned int flickering = 8;
  } // namespace

  Newton::Newton(const NewtonParameters &parameters,
                 LinearSolver           &linear_solver)
    : parameters(parameters)
    , linear_solver(linear_solver)
  {}

  bool Newton::assemble(WeakForm     &weak_form,
                        const bool    tangent,
                        NewtonReport &report)
  {
    Timer      timer;
    const bool admissible = weak_form.assemble(tangent, report.iterations);
    seconds_assembly += timer.wall_time();
    if (!admissible)
      {
        report.reason = "an element turned inside out";
        return false;
      }
    const double residual = measure(weak_form, largest_force, tangent);
    report.residuals.push_back(residual);
    report.state_changes.push_back(weak_form.n_state_changes());
    if (!std::isfinite(residual))
      report.reason = "the residual is not a number";
    return std::isfinite(residual);
  }

  bool Newton::has_converged(const NewtonReport &report) const
  {
    return report.iterations > 0 &&
           report.residuals.back() <= parameters.residual_tolerance &&
           (last_work <= parameters.energy_tolerance * largest_work ||
            report.residuals.back() <= .1 * parameters.residual_tolerance ||
            report.iterations > flickering);
  }

  /// How exact a linear solution must be (Eisenstat and Walker 1996, choice
  /// 2): the last digits of an early correction would be thrown away. But not
  /// of the first: what the supports impose sits in few rows, and half solved
  /// it turns the elements beside them inside out.
  double Newton::forcing_term(const NewtonReport &report) const
  {
    const auto &r = report.residuals;
    if (r.size() == 1)
      return 1e-3;
    const double aim =
      .1 * parameters.residual_tolerance / std::max(r.back(), 1e-300);
    double eta = 1e-2;
    if (r[r.size() - 2] > 0.)
      eta = .9 * std::pow(r.back() / r[r.size() - 2], 2);
    return std::min(1e-2, std::max({eta, aim, 1e-8}));
  }

  void Newton::search_line(WeakForm     &weak_form,
                           const Vector &du,
                           NewtonReport &report)
  {
    const double before = report.residuals.back();
    double       factor = 1.;
    weak_form.update(du, 1.);
    for (unsigned int halving = 0; halving < 5; ++halving)
      {
        const bool admissible = weak_form.assemble(false, report.iterations);
        const ResidualNorms norms = weak_form.residual_norms();
        if (admissible && norms.free / std::max(norms.scale, 1e-300) < before)
          return;
        weak_form.update(du, -.5 * factor);
        factor *= .5;
      }
  }

  NewtonReport Newton::solve(WeakForm &weak_form)
  {
    NewtonReport report;
    measure      = ResidualMeasure();
    largest_work = last_work = 0.;
    if (pattern_number != weak_form.pattern_number())
      linear_solver.forget();
    pattern_number = weak_form.pattern_number();
    correction     = weak_form.new_vector();

    if (!assemble(weak_form, true, report))
      return report;
    while (true)
      {
        if (report.iterations >= parameters.max_iterations)
          {
            report.reason = "no convergence in " +
                            std::to_string(parameters.max_iterations) +
                            " iterations";
            return report;
          }
        if (pattern_number != weak_form.pattern_number())
          linear_solver.forget();
        pattern_number = weak_form.pattern_number();
        correction     = 0.;
        const auto outcome =
          linear_solver.solve(weak_form.matrix,
                              correction,
                              weak_form.right_hand_side,
                              forcing_term(report),
                              weak_form.symmetric(),
                              weak_form.has_extra_unknowns());
        if (outcome == LinearSolver::Outcome::singular)
          {
            report.reason = "the tangent is singular";
            return report;
          }
        last_work    = std::abs(weak_form.work_of_residual(correction));
        largest_work = std::max(largest_work, last_work);
        ++report.iterations;
        if (parameters.line_search && report.iterations > 1)
          search_line(weak_form, correction, report);
        else
          weak_form.update(correction, 1.);

        // Quadratic convergence: after a small residual the next one will
        // do, so that only the residual is asked for.
        const bool almost = report.iterations > 1 &&
                            report.residuals.back() <
                              .1 * std::sqrt(parameters.residual_tolerance);
        if (!assemble(weak_form, !almost, report))
          return report;
        if (has_converged(report) && weak_form.has_settled())
          {
            report.converged = true;
            report.force     = weak_form.residual_norms().scale;
            return report;
          }
        if (report.residuals.size() > 3 && report.residuals.back() > 1e8)
          {
            report.reason = "the residual grows without bound";
            return report;
          }
        if (almost)
          {
            report.residuals.pop_back();
            report.state_changes.pop_back();
            if (!assemble(weak_form, true, report))
              return report;
          }
      }
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Increments of time that are cut, grown and rolled back.
#include "solution/adaptive_increments.h"

#include "base/parameter_error.h"
#include "weak_form/weak_form.h"

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace demold
{
  using namespace dealii;

  std::vector<double> IncrementState::save() const
  {
    return {dt,
            last_dt,
            static_cast<double>(rejected),
            static_cast<double>(newton_iterations)};
  }

  void IncrementState::load(const std::vector<double> &values)
  {
    dt                = values.at(0);
    last_dt           = values.at(1);
    rejected          = static_cast<unsigned int>(values.at(2));
    newton_iterations = static_cast<unsigned int>(values.at(3));
  }

  void IncrementParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("first increment",
                      first,
                      "dt_0 first increment; 0: 1/200 of the process, at most "
                      "the largest one [s]",
                      Patterns::Double(0.));
    prm.add_parameter("smallest increment",
                      smallest,
                      "dt_min below which the run gives up; 0: 1e-9 of the "
                      "process [s]",
                      Patterns::Double(0.));
    prm.add_parameter("largest increment",
                      largest,
                      "dt_max; 0: 1/50 of the process; of explicit dynamics: "
                      "between two records, 0: 1/500 [s]",
                      Patterns::Double(0.));
    prm.add_parameter("growth",
                      growth,
                      "largest ratio of consecutive increments [-]",
                      Patterns::Double(1., 10.));
    prm.add_parameter("easy iterations",
                      easy,
                      "Newton iterations up to which increments grow [-]",
                      Patterns::Integer(1, 100));
  }

  void IncrementParameters::check() const
  {
    if (largest > 0. && smallest > largest)
      throw ExcParameter("Solution/smallest increment",
                         "must not exceed Solution/largest increment = " +
                           std::to_string(largest) + " s; got " +
                           std::to_string(smallest) + " s. Lower it.");
    if (largest > 0. && first > largest)
      throw ExcParameter("Solution/first increment",
                         "must not exceed Solution/largest increment = " +
                           std::to_string(largest) + " s; got " +
                           std::to_string(first) + " s. Lower it.");
  }

  namespace
  {
    std::string residual_history(const NewtonReport &report)
    {
      std::string text = "relative residuals";
      char        number[32];
      for (const double r : report.residuals)
        {
          std::snprintf(number, sizeof(number), " %.1e", r);
          text += number;
        }
      return text;
    }
  } // namespace

  IncrementVerdict judge_by_terms(const WeakForm &weak_form)
  {
    IncrementVerdict verdict;
    for (const auto &term : weak_form.term_list())
      {
        const IncrementError error = term->increment_error();
        if (error.ratio <= 0.)
          continue;
        // Errors of higher order are aimed at half of what is accepted.
        const double aim = error.order > 1. ? .5 : 1.;
        verdict.factor =
          std::min(verdict.factor,
                   .9 * std::pow(aim / error.ratio, 1. / error.order));
        if (error.ratio > 1.)
          {
            verdict.accept = false;
            verdict.reason = term->name() + " error is " +
                             std::to_string(error.ratio) +
                             " times what is tolerated";
          }
      }
    verdict.factor = std::max(.1, verdict.factor);
    return verdict;
  }

  namespace
  {
    bool has_state_changes(const NewtonReport &report)
    {
      return std::any_of(report.state_changes.begin(),
                         report.state_changes.end(),
                         [](const auto n) { return n > 0; });
    }
  } // namespace

  StrategyResult run_increments(WeakForm                  &weak_form,
                                NonlinearSolver           &newton,
                                const IncrementParameters &parameters,
                                const double               end_time,
                                const IncrementHooks      &hooks,
                                const OnAccept            &on_accept)
  {
    StrategyResult  result;
    IncrementState  local;
    IncrementState &state =
      parameters.state != nullptr ? *parameters.state : local;
    double &dt = state.dt, &last_dt = state.last_dt;
    result.rejected          = state.rejected;
    result.newton_iterations = state.newton_iterations;
    if (dt <= 0.)
      dt = parameters.first;
    const double tiny = 1e-12 * end_time;
    while (end_time - weak_form.time() > tiny)
      {
        const double start = weak_form.time();
        const double rest  = end_time - start;
        dt                 = std::min(dt, parameters.largest);
        // Two equal increments rather than a long and a very short one.
        const double step = dt >= (1. - 1e-9) * rest ? rest :
                            dt > .5 * rest           ? .5 * rest :
                                                       dt;

        hooks.before(step);
        weak_form.begin_increment(start + step,
                                  hooks.extrapolate && last_dt > 0. ?
                                    step / last_dt :
                                    0.);
        const NewtonReport report = newton.solve(weak_form);
        result.newton_iterations += report.iterations;
        state.newton_iterations = result.newton_iterations;
        const IncrementVerdict verdict =
          report.converged ? hooks.judge(step) : IncrementVerdict();

        if (!report.converged || !verdict.accept)
          {
            weak_form.reject();
            state.rejected = ++result.rejected;
            dt             = step * (report.converged ?
                                       std::max(.1, std::min(.5, verdict.factor)) :
                                       .5);
            last_dt        = 0.; // no extrapolation from here
            if (dt < parameters.smallest)
              {
                result.gave_up = true;
                char times[160];
                std::snprintf(times,
                              sizeof(times),
                              "the increment at time %.6g s fell below "
                              "%.3g s: ",
                              start,
                              parameters.smallest);
                result.reason =
                  times + (report.converged ? verdict.reason : report.reason) +
                  "; " + residual_history(report);
                return result;
              }
            continue;
          }

        weak_form.accept();
        newton.accept(report);
        hooks.after_accept();
        ++result.increments;
        // Where surfaces meet first, the increment says little of the next.
        last_dt = start == 0. && has_state_changes(report) ? 0. : step;
        if (report.iterations <= parameters.easy)
          dt = step * std::min(parameters.growth, verdict.factor);
        else
          dt = step * std::min(1., verdict.factor);
        dt = std::max(dt, std::min(step, parameters.smallest));
        if (!on_accept({weak_form.time(),
                        step,
                        report,
                        hooks.name,
                        result.rejected,
                        {}}))
          return result;
      }
    return result;
  }
} // namespace demold

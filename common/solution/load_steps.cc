// SPDX-License-Identifier: LGPL-2.1-or-later
// Steps of path following forward in time, and what all its steps share.
#include "solution/path_follower.h"
#include "solution/softening_overview.h"
#include "weak_form/weak_form.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace demold
{
  namespace
  {
    /// A step that releases more than this times what it may has jumped.
    constexpr double tolerated_release = 1.5;

    /// What a step may leave unexplained, share of the largest ledger entry.
    constexpr double tolerated_gap = 5e-4;

    /// Load steps shorter than this share of the largest increment are not cut
    /// for accuracy any more: what still happens in one of them is a jump.
    constexpr double jump_resolution = 1e-3;
  } // namespace

  /// The points at the accepted state, which the trial is set to.
  PathFollower::Points PathFollower::look()
  {
    weak_form.begin_increment(weak_form.time(), 0.);
    weak_form.assemble(false, 0);
    const Points points  = softening_sites(weak_form);
    double       largest = 0.;
    for (const SofteningSite &point : points)
      largest = std::max(largest, point.whole);
    whole = max_over_ranks(weak_form, largest);
    return points;
  }

  /// Asks the converged trial; @p points may release their share each.
  bool PathFollower::releases_too_much(const double points) const
  {
    return weak_form.energies().adhesion - books.accepted.adhesion >
           tolerated_release * tools.path.release * whole *
             std::max(points, 1.);
  }

  /// A step that has lost more than the ledger explains has gone to another
  /// branch, even if it released no more than it may.
  bool PathFollower::leaves_the_books_open()
  {
    books.trial = weak_form.energies();
    return books.unexplained_share() > tolerated_gap;
  }

  void PathFollower::reject(const NewtonReport &report, const std::string &why)
  {
    weak_form.reject();
    state.newton_iterations = result.newton_iterations += report.iterations;
    state.rejected          = ++result.rejected;
    last_problem            = report.converged ? why : report.reason;
  }

  void PathFollower::accept(const NewtonReport &report,
                            const std::string  &used,
                            const std::string  &strategy,
                            const double        damped)
  {
    excursion.look(weak_form);
    constraint->accepted(weak_form);
    PathPoint point;
    point.kind       = excursion.kind;
    point.released   = excursion.released;
    point.constraint = used;
    point.damped     = damped;
    if (damped > 0.)
      point.kind = "jump";
    const bool wants_mode = tools.path.eigenvalue || tools.path.branch;
    if (tools.path.monitor || wants_mode)
      point.stability = read_stability(weak_form,
                                       tools.linear_solver,
                                       PathCorrector::stage(report.iterations),
                                       wants_mode ? &mode : nullptr);
    report_stability(point.stability);
    const double start = weak_form.time();
    weak_form.accept();
    tools.newton.accept(report);
    books.trial = weak_form.energies();
    books.accept();
    point.clock = weak_form.clock();
    ++result.increments;
    state.newton_iterations = result.newton_iterations += report.iterations;
    save();
    goes_on = on_accept({weak_form.time(),
                         weak_form.time() - start,
                         report,
                         strategy,
                         result.rejected,
                         point});
  }

  /// Limit points and bifurcations lie where the number of negative pivots
  /// changes (theory D.3).
  void PathFollower::report_stability(const StabilityReading &reading)
  {
    const int now = reading.negative_pivots, before = stability.negative_pivots;
    stability = reading;
    if (now < 0 || before < 0 || now == before)
      return;
    char text[160];
    std::snprintf(text,
                  sizeof(text),
                  "time %.6g s: %d negative pivots after %d, %s",
                  weak_form.trial_time(),
                  now,
                  before,
                  now == 0                ? "stable again" :
                  now == 1 && before == 0 ? "beyond a limit point" :
                  now > before            ? "beyond a bifurcation" :
                                            "closer to a stable branch");
    result.events.emplace_back(text);
    tools.note(text);
  }

  bool PathFollower::try_load(const double dt)
  {
    weak_form.begin_increment(weak_form.time() + dt,
                              last_load > 0. && dt > 0. ? dt / last_load : 0.);
    newton.largest_force      = tools.newton.largest_force;
    newton.seconds_assembly   = 0.;
    const NewtonReport report = newton.solve(weak_form);
    tools.newton.seconds_assembly += newton.seconds_assembly;
    const bool open = report.converged && leaves_the_books_open();
    // Rubber that buckles or comes free of an edge jumps without a bond.
    const bool jumps = open && books.loses() && dt > 0. &&
                       dt <= jump_resolution * increments.largest;
    if (!report.converged || releases_too_much(1.) || (open && !jumps))
      {
        reject(report,
               open ? "a load step loses more energy than the ledger explains" :
                      "a load step releases more energy than it may");
        last_load = 0.;
        return false;
      }
    last_load = std::max(dt, 0.);
    if (report.iterations <= increments.easy)
      state.dt = std::max(state.dt,
                          std::min(increments.growth * dt, increments.largest));
    accept(report, "load", jumps ? "quasi-static" : "arc length");
    return true;
  }

  /// Time [s] that no step passes: where the path has turned back, or the end.
  double PathFollower::next_mark() const
  {
    const double clock = weak_form.clock();
    return weak_form.time() < clock * (1. - 1e-12) ? clock : end_time;
  }

  bool PathFollower::load_step()
  {
    state.dt          = std::min(state.dt, increments.largest);
    const double rest = next_mark() - weak_form.time();
    const double step = state.dt >= (1. - 1e-9) * rest ? rest :
                        state.dt > .5 * rest           ? .5 * rest :
                                                         state.dt;
    return try_load(step) || meet_limit(step);
  }

  /// A load step has failed: is something about to give, or soon?
  bool PathFollower::meet_limit(const double step)
  {
    const Points points = look();
    const bool   any = std::any_of(points.begin(), points.end(), is_critical);
    if (max_over_ranks(weak_form, any) > 0.)
      {
        begin_path(last_problem);
        return true;
      }
    // Shorter the next time, as an onset may be a mistake of the probe.
    state.dt           = .5 * step;
    const double onset = onset_within(step);
    if (onset > 0. && try_load(onset))
      return true;
    if (state.dt >= increments.smallest)
      return true;
    if (!choose_next_constraint(last_problem))
      return false;
    state.dt = increments.first;
    return true;
  }

  /// Time [s] from t_n to the first point on the verge of softening, by the
  /// rates of a small probe; 0 if that is not within @p step.
  double PathFollower::onset_within(const double step)
  {
    const Points before = look();
    const double probe  = 1e-4 * step;
    weak_form.begin_increment(weak_form.time() + probe, 0.);
    newton.largest_force      = tools.newton.largest_force;
    const NewtonReport report = newton.solve(weak_form);
    double             onset  = 1e300;
    if (report.converged)
      {
        const Points after = softening_sites(weak_form);
        for (std::size_t k = 0; k < before.size(); ++k)
          {
            const double rate =
              (after[k].utilisation - before[k].utilisation) / probe;
            if (rate > 0. && before[k].left > 0.)
              onset =
                std::min(onset, (1. - 1e-6 - before[k].utilisation) / rate);
          }
      }
    weak_form.reject();
    onset = -max_over_ranks(weak_form, -onset);
    return onset < step ? std::max(onset, 0.) : 0.;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Steps of path following along the path.
#include "solution/path_follower.h"
#include "solution/softening_overview.h"
#include "weak_form/weak_form.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  namespace
  {
    /// Along the path a load step is tried again after so many steps.
    constexpr unsigned int steps_between_tries = 15;

    /// Times a path step may go back or forth of the largest increment.
    constexpr double foreign_branch = 10.;

    /// Path steps shorter than this share of the nominal one are given up.
    constexpr double shortest_path_step = 2e-4;

    /// Single points tried where the critical ones together find no way.
    constexpr unsigned int single_points = 4;
  } // namespace

  bool PathFollower::path_step()
  {
    const Points points = look();
    const bool   any = std::any_of(points.begin(), points.end(), is_critical);
    if (is_cylindrical() && tools.path.constraint == "adaptive" &&
        max_over_ranks(weak_form, points.size()) > 0.)
      {
        choose_first_constraint();
        end_path("there is something that softens now");
        return true;
      }
    if (is_cylindrical() && cylindrical->length == 0.)
      {
        if (!try_load(std::min(state.dt, end_time - weak_form.time())))
          {
            state.dt *= .5;
            return state.dt >= increments.smallest || give_up(last_problem);
          }
        Vector du = weak_form.last_increment();
        weak_form.set_supports_to_zero(du);
        cylindrical->length = du.l2_norm();
        return true;
      }
    if (!is_cylindrical() && max_over_ranks(weak_form, any) == 0.)
      {
        end_path("no point is about to soften");
        return true;
      }
    if (!is_cylindrical() && path_steps >= steps_between_tries)
      {
        path_steps = 0;
        if (try_load(std::min(state.dt, next_mark() - weak_form.time())))
          {
            end_path("time can go forward again");
            return true;
          }
        look();
      }
    return try_branch(points) || try_path(is_critical, false) ||
           try_single_points(points) || shorten_path_step();
  }

  bool PathFollower::try_path(const Chosen &chosen, const bool may_pass)
  {
    const double start = weak_form.time();
    look();
    const unsigned int n = is_cylindrical() ? 0 : drive(weak_form, chosen);
    constraint->start(weak_form, size);
    const NewtonReport report =
      corrector.solve(weak_form, *constraint, 1e-6 * increments.largest);
    const double dt   = weak_form.trial_time() - start;
    const double mark = next_mark();
    if (!report.converged || releases_too_much(n) || leaves_the_books_open() ||
        std::abs(dt) > foreign_branch * increments.largest)
      {
        reject(report,
               std::abs(dt) > foreign_branch * increments.largest ?
                 "the path step ended on another branch" :
                 "the path step releases more energy than it may");
        return false;
      }
    if (!may_pass && start + dt > mark * (1. + 1e-12))
      {
        // What has turned back comes to the clock exactly, if it can.
        weak_form.reject();
        return try_load(mark - start) || try_path(chosen, true);
      }
    ++path_steps;
    last_load = 0.;
    adapt_path_step(report, dt);
    accept(report, constraint->name(), "arc length");
    return true;
  }

  void PathFollower::adapt_path_step(const NewtonReport &report,
                                     const double        dt)
  {
    const double most = is_cylindrical() ? 5. : tools.path.release;
    if (report.iterations <= increments.easy)
      size = std::min(most, size * increments.growth);
    if (std::abs(dt) > increments.largest)
      size *= std::max(.2, increments.largest / std::abs(dt));
  }

  /// Where several points could give and together find no way, one does: those
  /// that have opened most first, as the front goes on there.
  bool PathFollower::try_single_points(const Points &points)
  {
    if (is_cylindrical() || sum_over_ranks(weak_form,
                                           std::count_if(points.begin(),
                                                         points.end(),
                                                         is_critical)) < 2.)
      return false;
    const auto damage = [](const SofteningSite &point) {
      return point.largest / point.rupture;
    };
    double below = 1e300;
    for (unsigned int i = 0; i < single_points; ++i)
      {
        double most = 0.;
        for (const SofteningSite &point : points)
          if (is_critical(point) && damage(point) < below)
            most = std::max(most, damage(point));
        most = max_over_ranks(weak_form, most);
        if (most == 0.)
          return false;
        if (try_path(
              [&](const SofteningSite &p) {
                return is_critical(p) && damage(p) == most;
              },
              false))
          return true;
        below = most;
      }
    return false;
  }

  bool PathFollower::shorten_path_step()
  {
    size *= .5;
    if (size >=
        shortest_path_step * (is_cylindrical() ? 1. : tools.path.release))
      return true;
    size = is_cylindrical() ? 1. : tools.path.release;
    // A small step forth or back may come round the kink; once is enough.
    look();
    if (nudged != weak_form.clock())
      {
        nudged = weak_form.clock();
        for (const double direction : {1., -1.})
          if (try_load(direction * 1e-3 * increments.largest))
            return true;
      }
    return choose_next_constraint(last_problem);
  }
} // namespace demold

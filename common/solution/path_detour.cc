// SPDX-License-Identifier: LGPL-2.1-or-later
// Along the path past a limit point whose jump is small.
#include "solution/path_detour.h"

#include "weak_form/weak_form.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace demold
{
  namespace
  {
    /// Work that the machine gets back on the way, over what may be released:
    /// a path that goes back further is not expected to release so little.
    constexpr double deepest = 10.;

    /// The constraint that needs no sign, and no slide where it fails: whoever
    /// comes here has dynamics at hand.
    PathTools for_detours(PathTools tools)
    {
      tools.path.constraint = "dissipation";
      tools.path.monitor = tools.path.eigenvalue = tools.path.branch = false;
      tools.note = [](const std::string &) {};
      return tools;
    }
  } // namespace

  std::optional<IncrementRecord>
  try_detour(WeakForm                  &weak_form,
             const PathTools           &tools,
             const IncrementParameters &increments,
             const double               end_time,
             const DetourLimits        &limits)
  {
    std::ostringstream before;
    weak_form.save(before);
    const double start    = weak_form.time();
    const double external = weak_form.energies().external;
    const double force    = tools.newton.largest_force;
    const double enough =
      std::min(start + increments.smallest, end_time * (1. - 1e-12));

    IncrementState way;
    way.dt                      = increments.smallest;
    IncrementParameters shorter = increments;
    shorter.state               = &way;

    IncrementRecord      whole{start, 0., {}, "arc length", 0, PathPoint()};
    unsigned int         points  = 0;
    bool                 arrived = false;
    const StrategyResult result  = run_path_following(
      weak_form,
      for_detours(tools),
      shorter,
      end_time,
      [&](const IncrementRecord &record) {
        const double so_far = whole.path->released;
        whole.time          = record.time;
        whole.newton        = record.newton;
        whole.path          = record.path;
        whole.path->released += so_far;
        const double back = external - weak_form.energies().external;
        // A load step may jump as well: no excursion shows it.
        const bool jumps = record.strategy != "arc length";
        if (jumps || ++points + record.rejected > limits.points ||
            back > deepest * limits.released ||
            std::abs(whole.path->released) > limits.released)
          return false;
        arrived = record.path->kind != "static path" && record.time >= enough;
        return !arrived;
      });
    if (increments.state != nullptr)
      {
        increments.state->newton_iterations += result.newton_iterations;
        increments.state->rejected += result.rejected;
        whole.rejected = increments.state->rejected;
      }
    if (arrived)
      {
        whole.dt         = whole.time - start;
        whole.path->kind = "jump";
        return whole;
      }
    std::istringstream in(before.str());
    weak_form.load(in);
    tools.newton.largest_force = force;
    return std::nullopt;
  }
} // namespace demold

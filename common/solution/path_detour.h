// SPDX-License-Identifier: LGPL-2.1-or-later
// Along the path past a limit point whose jump is small.
#ifndef demold_solution_path_detour_h
#define demold_solution_path_detour_h

#include "solution/path_following.h"

#include <optional>

namespace demold
{
  /// What a detour may cost before it is given up.
  struct DetourLimits
  {
    double       released; ///< [mJ] largest jump
    unsigned int points;   ///< along the path, found or not
  };

  /// From where quasi-statics has stopped along the path, until time goes
  /// forward again: by a shortest increment of @p increments at least. A
  /// machine sees one increment, with what it releases. Nothing, and @p
  /// weak_form as it was, if that is more than it may be or no path is found.
  /// Bonds must not have a viscous time: none passes along the path. The
  /// constraint is dissipation, in steps of `tools.path.release`.
  std::optional<IncrementRecord>
  try_detour(WeakForm                  &weak_form,
             const PathTools           &tools,
             const IncrementParameters &increments,
             const double               end_time,
             const DetourLimits        &limits);
} // namespace demold

#endif

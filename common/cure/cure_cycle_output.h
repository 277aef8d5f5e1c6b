// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables and pictures of a press cycle.
#ifndef demold_cure_cure_cycle_output_h
#define demold_cure_cure_cycle_output_h

#include "cure/cure_model.h"

#include <string>
#include <vector>

namespace demold
{
  /// One depth over the time of the cycle.
  struct DepthHistory
  {
    double                 depth;       ///< [mm]
    std::vector<double>    temperature; ///< [degC]
    std::vector<CureState> state;
    std::vector<double>    degree; ///< [-]
  };

  /// Writes history.csv into @p folder: temperature, f90 and degree of cure of
  /// all @p histories at @p times [s].
  void write_cure_history(const std::string               &folder,
                          const std::vector<double>       &times,
                          const std::vector<DepthHistory> &histories);

  /// Writes profile.csv: the same over the depth, at time number @p opening and
  /// at the last.
  void write_cure_profile(const std::string               &folder,
                          const std::size_t                opening,
                          const std::vector<DepthHistory> &profile);

  /// Draws both tables. Returns an empty text or what went wrong.
  std::string draw_cure_cycle(const std::string               &folder,
                              const std::vector<DepthHistory> &histories);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// One run of a study: what was set, how it ended, what it gave.
#ifndef demold_study_study_run_h
#define demold_study_study_run_h

#include "study/sweep.h"

#include <limits>
#include <string>
#include <vector>

namespace demold
{
  struct ChildEnd;
  struct StudyParameters;

  /// A row of the table. Unknown numbers are NaN.
  struct StudyRun
  {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    Combination values; ///< one for each sweep
    std::string folder; ///< of its results

    std::string status = "not run"; ///< "completed", "gave up", "killed" ...
    std::string reason;
    double      cpu_time   = unknown; ///< [s]
    double      n_unknowns = unknown;
    double      quantity   = unknown;
    std::vector<std::string> also; ///< further entries, as text

    double reference = unknown; ///< in the unit of the quantity
    double error     = unknown; ///< relative or absolute, not negative
    double order     = unknown; ///< against the next coarser run of the series
    bool   is_reference = false;
    bool   on_front     = false; ///< of error and CPU time

    /// Did it end with exit code 0?
    bool completed = false;
  };

  /// All runs of @p study, with folders below @p output/runs.
  std::vector<StudyRun> planned_runs(const StudyParameters &study,
                                     const std::string     &output);

  /// Fills status, reason, times and quantities of a run from its folder. What
  /// is missing or broken becomes its reason. A quantity that a completed run
  /// does not have at all throws ExcParameter, with the nearest names: the
  /// study has misspelt it.
  void read_results(StudyRun &run, const StudyParameters &study);

  /// Notes in the folder of @p run that it has ended by itself, and how.
  void write_outcome(const StudyRun &run, const ChildEnd &end);

  /// Has @p run ended by itself, and left a summary?
  bool has_results(const StudyRun &run);
} // namespace demold

#endif

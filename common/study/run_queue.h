// SPDX-License-Identifier: LGPL-2.1-or-later
// Performs the runs of a study, several at a time, and can be interrupted.
#ifndef demold_study_run_queue_h
#define demold_study_run_queue_h

#include "study/study_run.h"

#include <iosfwd>
#include <vector>

namespace demold
{
  class StepProgram;

  /// Runs with the settings and the results they would have now: they need not
  /// be repeated. One entry per run.
  std::vector<bool> finished_runs(const std::vector<StudyRun> &runs,
                                  const StepProgram           &program);

  /// Performs those of @p runs that are not @p finished and reads the results
  /// of all. A line on @p out for each, with an estimate of the time left.
  /// Returns false if a signal has ended it; the runs it has interrupted are
  /// left as "not run". Throws ExcParameter if the first run that completes
  /// lacks the quantity.
  bool perform_runs(std::vector<StudyRun>   &runs,
                    const std::vector<bool> &finished,
                    const StepProgram       &program,
                    const StudyParameters   &study,
                    std::ostream            &out);
} // namespace demold

#endif

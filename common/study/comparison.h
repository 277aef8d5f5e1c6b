// SPDX-License-Identifier: LGPL-2.1-or-later
// Errors, orders and the Pareto front of the runs of a study.
#ifndef demold_study_comparison_h
#define demold_study_comparison_h

#include "study/study_run.h"

#include <string>
#include <vector>

namespace demold
{
  struct StudyParameters;

  /// Runs that differ in the refined sweep only.
  struct Series
  {
    std::string              name; ///< "element = q2"; empty if it is the only
    std::vector<std::size_t> runs; ///< positions, coarse to fine
    double                   order = StudyRun::unknown; ///< fitted to all
  };

  /// The series of @p runs. Without a refined sweep they are one.
  std::vector<Series> series_of(const StudyParameters       &study,
                                const std::vector<StudyRun> &runs);

  /// Fills reference, error, order and on_front of @p runs, and the orders of
  /// the series it returns. For the front, errors count with three digits.
  std::vector<Series> compare_runs(const StudyParameters &study,
                                   std::vector<StudyRun> &runs);
} // namespace demold

#endif

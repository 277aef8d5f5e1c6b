// SPDX-License-Identifier: LGPL-2.1-or-later
// study.csv and study.md: what a study has found, as a table and in words.
#ifndef demold_study_study_report_h
#define demold_study_study_report_h

#include "study/comparison.h"

#include <string>
#include <vector>

namespace demold
{
  struct StudyParameters;

  /// Writes @p file, a row per run, numbers with all their digits. Throws
  /// std::runtime_error if the disk is full.
  void write_csv(const std::string           &file,
                 const StudyParameters       &study,
                 const std::vector<StudyRun> &runs);

  /// The same for people: what was done, the table with four digits, the
  /// orders and the Pareto front in words, and @p picture (may be empty).
  std::string report_text(const StudyParameters       &study,
                          const std::vector<StudyRun> &runs,
                          const std::vector<Series>   &all_series,
                          const std::string           &picture);
} // namespace demold

#endif

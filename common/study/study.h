// SPDX-License-Identifier: LGPL-2.1-or-later
// main() of the study: reads the file, performs the runs, writes the table.
#ifndef demold_study_study_h
#define demold_study_study_h

#include <string>
#include <vector>

namespace demold
{
  /// Runs a study with the @p arguments of the command line and returns the
  /// exit code: 0 the table is written, 1 stopped or the disk is full, 2 bad
  /// input and nothing written. The steps are @p programs/STEP/STEP.
  int run_study(const std::vector<std::string> &arguments,
                const std::string              &programs);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Error over CPU time of a study, with orders and the Pareto front.
#ifndef demold_study_study_picture_h
#define demold_study_study_picture_h

#include "study/comparison.h"

#include <string>
#include <vector>

namespace demold
{
  struct StudyParameters;

  /// A picture as gnuplot draws it.
  struct StudyPicture
  {
    std::string name;   ///< of the files; empty: there is nothing to draw
    std::string script; ///< of gnuplot, with its data
  };

  /// Both axes logarithmic, a line per series with its order in the key, points
  /// of the Pareto front ringed and joined. Without a reference: the quantity
  /// over the refined entry instead.
  StudyPicture picture_of(const StudyParameters       &study,
                          const std::vector<StudyRun> &runs,
                          const std::vector<Series>   &all_series);
} // namespace demold

#endif

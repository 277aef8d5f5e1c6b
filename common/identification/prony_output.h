// SPDX-License-Identifier: LGPL-2.1-or-later
// What fits of Prony series in frequency and in time write alike.
#ifndef demold_identification_prony_output_h
#define demold_identification_prony_output_h

#include "identification/prony_choice.h"

#include <string>
#include <vector>

namespace demold
{
  class Summary;

  /// series.csv: a row per branch, a column of moduli for each of @p names, the
  /// last row E_inf (relaxation time: inf).
  void write_series(const std::string              &folder,
                    const std::vector<std::string> &names,
                    const std::vector<PronySeries> &series);

  /// branches.csv: the series that have been tried.
  void write_trials(const std::string                     &folder,
                    const std::vector<PronyChoice::Trial> &trials);

  /// Relaxation times, moduli with their uncertainties, rms of each of @p
  /// names, the number of branches.
  void add_to_summary(const PronyChoice              &choice,
                      const PronyChoice::Outcome     &outcome,
                      const std::vector<std::string> &names,
                      Summary                        &summary);
} // namespace demold

#endif

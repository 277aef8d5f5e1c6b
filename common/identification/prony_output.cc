// SPDX-License-Identifier: LGPL-2.1-or-later
// What fits of Prony series in frequency and in time write alike.
#include "identification/prony_output.h"

#include "output/result_table.h"
#include "output/summary.h"

#include <algorithm>
#include <limits>

namespace demold
{
  namespace
  {
    /// The quantity in percent, or as it is for absolute weights.
    void set_rms(const PronyChoice &choice,
                 const std::string &name,
                 const double       rms,
                 Summary           &summary)
    {
      if (choice.relative())
        summary.set(name + " [%]", 100. * rms);
      else
        summary.set(name + " [MPa]", rms);
    }
  } // namespace



  void write_series(const std::string              &folder,
                    const std::vector<std::string> &names,
                    const std::vector<PronySeries> &series)
  {
    std::vector<std::string> columns{"relaxation time [s]"};
    for (const auto &name : names)
      columns.push_back("modulus" + (name.empty() ? "" : " at " + name) +
                        " [MPa]");
    ResultTable        table(folder + "/series.csv", columns);
    const unsigned int n = series[0].times.size();
    for (unsigned int j = 0; j <= n; ++j)
      {
        std::vector<ResultTable::Value> row{
          j < n ? series[0].times[j] : std::numeric_limits<double>::infinity()};
        for (const auto &s : series)
          row.emplace_back(j < n ? s.moduli[j] : s.equilibrium);
        table.add_row(row);
      }
  }



  void write_trials(const std::string                     &folder,
                    const std::vector<PronyChoice::Trial> &trials)
  {
    ResultTable table(folder + "/branches.csv",
                      {"branches [-]",
                       "parameters that are not zero [-]",
                       "rms",
                       "information criterion AICc [-]"});
    for (const auto &trial : trials)
      table.add_row({static_cast<double>(trial.n_branches),
                     static_cast<double>(trial.n_parameters),
                     trial.rms,
                     trial.criterion});
  }



  void add_to_summary(const PronyChoice              &choice,
                      const PronyChoice::Outcome     &outcome,
                      const std::vector<std::string> &names,
                      Summary                        &summary)
  {
    const auto &best = outcome.best;
    summary.set("branches [-]", best.series[0].times.size());
    set_rms(choice, "rms", best.report.rms, summary);
    for (unsigned int c = 0; c < names.size() && names.size() > 1; ++c)
      set_rms(choice, "rms at " + names[c], best.rms[c], summary);
    summary.set("information criterion AICc [-]", best.criterion());
    for (unsigned int j = 0; j < best.series[0].times.size(); ++j)
      summary.set("tau_" + std::to_string(j + 1) + " [s]",
                  best.series[0].times[j]);
    best.report.write(choice.relative() ? "-" : "MPa", summary);
    summary.set("remaining slope [-]", best.slope);
  }
} // namespace demold

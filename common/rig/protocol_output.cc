// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables and pictures of the runs of a protocol.
#include "rig/protocol_output.h"

#include "output/result_table.h"

#include <algorithm>

namespace demold
{
  namespace
  {
    using Columns = std::vector<std::string>;
    using Row     = std::vector<ResultTable::Value>;

    Columns case_columns(const ProtocolParameters &p)
    {
      Columns columns = {"case [-]", "f90 [-]", "temperature [degC]"};
      if (!swept_column(p).empty())
        columns.push_back(swept_column(p));
      return columns;
    }

    Row case_row(const ProtocolParameters &p,
                 const ProtocolRun        &run,
                 const unsigned int        number)
    {
      Row row = {static_cast<double>(number),
                 run.test.f90,
                 run.test.temperature};
      if (!swept_column(p).empty())
        row.emplace_back(run.test.swept);
      return row;
    }

    bool starts_with(const std::string &text, const std::string &start)
    {
      return text.compare(0, start.size(), start) == 0;
    }
  } // namespace



  std::string swept_column(const ProtocolParameters &p)
  {
    return p.has_cycles()                         ? "frequency [Hz]" :
           p.programme() == Programme::rate_sweep ? "rate [1/s]" :
                                                    "";
  }

  std::string reference_column(const ProtocolParameters &p)
  {
    return p.programme() == Programme::creep ? "reference strain [-]" :
                                               "reference stress [MPa]";
  }



  void write_curves(const std::string              &file,
                    const ProtocolParameters       &p,
                    const std::vector<ProtocolRun> &runs)
  {
    Columns columns = case_columns(p);
    for (const char *const name : {"time [s]",
                                   "strain [-]",
                                   "lateral stretch [-]",
                                   "nominal stress [MPa]",
                                   "cauchy stress [MPa]",
                                   "side stress [MPa]",
                                   "stored energy [mJ/mm^3]",
                                   "dissipated energy [mJ/mm^3]",
                                   "work [mJ/mm^3]",
                                   "newton iterations"})
      columns.emplace_back(name);
    const bool with_reference = runs.front().has_reference();
    if (with_reference)
      columns.push_back(reference_column(p));

    ResultTable table(file, columns);
    const bool  shear = p.mode() == RigMode::simple_shear;
    for (unsigned int i = 0; i < runs.size(); ++i)
      {
        const auto &rows  = runs[i].curve.rows;
        std::size_t first = 0;
        if (p.programme() == Programme::frequency_sweep)
          first = rows.size() - p.n_steps - 1;
        for (std::size_t k = first; k < rows.size(); ++k)
          {
            const RigState &s   = rows[k].state;
            Row             row = case_row(p, runs[i], i + 1);
            for (const double value : {rows[k].time,
                                       s.strain,
                                       s.lateral,
                                       s.nominal,
                                       shear ? s.cauchy[0][1] : s.cauchy[0][0],
                                       s.cauchy[1][1],
                                       s.stored - rows.front().state.stored,
                                       rows[k].dissipated,
                                       rows[k].work,
                                       static_cast<double>(s.n_iterations)})
              row.emplace_back(value);
            if (with_reference)
              row.emplace_back(p.programme() == Programme::creep ?
                                 runs[i].reference.strain[k] :
                                 runs[i].reference.nominal[k]);
            table.add_row(row);
          }
      }
  }



  void write_cases(const std::string              &file,
                   const ProtocolParameters       &p,
                   const std::vector<ProtocolRun> &runs)
  {
    Columns columns = case_columns(p);
    for (const auto &quantity : runs.front().quantities)
      columns.push_back(quantity.first);
    ResultTable table(file, columns);
    for (unsigned int i = 0; i < runs.size(); ++i)
      {
        Row row = case_row(p, runs[i], i + 1);
        for (const auto &quantity : runs[i].quantities)
          row.emplace_back(quantity.second);
        table.add_row(row);
      }
  }



  Summary protocol_summary(const std::vector<ProtocolRun> &runs)
  {
    Summary summary;
    summary.set("status", "completed");
    summary.set("reason", "the programme has come to its end");
    summary.set("cases", runs.size());
    for (std::size_t k = 0; k < runs.front().quantities.size(); ++k)
      {
        const std::string name = runs.front().quantities[k].first;
        const bool        sums = name == "steps" || name == "cpu time [s]" ||
                          name == "newton iterations" ||
                          name == "reference steps";
        const bool largest = name.find("error") != std::string::npos;
        double     value   = runs.back().quantities[k].second;
        if (sums || largest)
          {
            value = 0.;
            for (const auto &run : runs)
              value = sums ? value + run.quantities[k].second :
                             std::max(value, run.quantities[k].second);
          }
        if (sums && !starts_with(name, "cpu"))
          summary.set(name, static_cast<long long>(value));
        else
          summary.set(name, value);
      }
    return summary;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// study.csv and study.md: what a study has found, as a table and in words.
#include "study/study_report.h"

#include "output/result_table.h"
#include "study/study_parameters.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace demold
{
  namespace
  {
    using Value = ResultTable::Value;

    struct Column
    {
      std::string        heading;
      std::vector<Value> cells;
    };



    Value number(const double value)
    {
      return std::isnan(value) ? Value(std::string()) : Value(value);
    }



    Value number_or_text(const std::string &text)
    {
      char        *end   = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      return end != text.c_str() && *end == '\0' ? Value(value) : Value(text);
    }



    bool is_compared(const StudyParameters &study)
    {
      return study.compare.reference != "none";
    }



    std::vector<Column> columns(const StudyParameters       &study,
                                const std::vector<StudyRun> &runs)
    {
      std::vector<Column> list;
      const auto add = [&](const std::string &heading, const auto &cell_of) {
        list.push_back({heading, {}});
        for (const StudyRun &run : runs)
          list.back().cells.push_back(cell_of(run));
      };
      const auto sweeps = study.sweeps();
      for (std::size_t s = 0; s < sweeps.size(); ++s)
        add(sweeps[s].heading(),
            [s](const StudyRun &run) { return Value(run.values[s]); });
      add("status", [](const StudyRun &run) { return Value(run.status); });
      add(study.compare.quantity,
          [](const StudyRun &run) { return number(run.quantity); });
      std::size_t k = 0;
      for (const auto &key : split_list(study.compare.also, ';'))
        {
          if (key != study.compare.quantity)
            add(key, [k](const StudyRun &run) {
              return number_or_text(run.also[k]);
            });
          ++k;
        }
      if (is_compared(study))
        {
          add("reference",
              [](const StudyRun &run) { return number(run.reference); });
          add(study.compare.error_heading(),
              [](const StudyRun &run) { return number(run.error); });
          add("observed order [-]",
              [](const StudyRun &run) { return number(run.order); });
        }
      add("cpu time [s]",
          [](const StudyRun &run) { return number(run.cpu_time); });
      add("unknowns",
          [](const StudyRun &run) { return number(run.n_unknowns); });
      if (is_compared(study))
        add("Pareto front", [](const StudyRun &run) {
          return Value(run.is_reference ? "reference" :
                       run.on_front     ? "yes" :
                                          "no");
        });
      add("reason", [](const StudyRun &run) { return Value(run.reason); });
      add("folder", [](const StudyRun &run) {
        return Value("runs/" +
                     std::filesystem::path(run.folder).filename().string());
      });
      return list;
    }



    std::string cell_text(const Value &value, const std::string &heading)
    {
      std::string text;
      if (const double *const x = std::get_if<double>(&value))
        {
          const bool is_error = heading.rfind("error ", 0) == 0;
          const bool is_count = heading == "unknowns";
          char       digits[40];
          std::snprintf(digits,
                        sizeof(digits),
                        is_error                          ? "%.2e" :
                        is_count                          ? "%.0f" :
                        heading == "observed order [-]"   ? "%.2f" :
                        heading.rfind("cpu time", 0) == 0 ? "%.3g" :
                                                            "%.6g",
                        *x);
          return digits;
        }
      for (const char c : std::get<std::string>(value))
        text += c == '|'  ? std::string("\\|") :
                c == '\n' ? std::string(" ") :
                            std::string(1, c);
      return text;
    }



    /// What all rows that ended well have in common says nothing in a table
    /// for people.
    bool is_worth_showing(const Column &column, const bool all_completed)
    {
      const Value &first = column.cells.front();
      return column.heading != "folder" &&
             (column.heading != "reason" ||
              (!all_completed && first != Value(std::string())) ||
              std::any_of(column.cells.begin(),
                          column.cells.end(),
                          [&](const Value &v) { return v != first; }));
    }



    std::string markdown_table(const std::vector<Column>   &all,
                               const std::vector<StudyRun> &runs)
    {
      const bool all_completed =
        std::all_of(runs.begin(), runs.end(), [](const StudyRun &run) {
          return run.completed;
        });
      std::vector<Column> shown;
      for (const Column &column : all)
        if (is_worth_showing(column, all_completed))
          shown.push_back(column);
      std::ostringstream text;
      for (const Column &column : shown)
        text << "| " << cell_text(Value(column.heading), "") << ' ';
      text << "|\n";
      for (std::size_t c = 0; c < shown.size(); ++c)
        text << "|---";
      text << "|\n";
      for (std::size_t row = 0; row < shown.front().cells.size(); ++row)
        {
          for (const Column &column : shown)
            text << "| " << cell_text(column.cells[row], column.heading) << ' ';
          text << "|\n";
        }
      return text.str();
    }



    std::string reference_in_words(const Comparison &compare)
    {
      if (compare.reference == "closed form")
        return "compared with " + compare.closed_form +
               (compare.definitions.empty() ? "" :
                                              ", where " + compare.definitions);
      if (compare.reference == "value")
        return "compared with " + cell_text(Value(compare.value), "");
      if (compare.reference == "finest")
        return "compared with the finest run of " +
               std::string(compare.among == "all runs" ? "all" : "each series");
      return "not compared with anything";
    }



    void put_findings(std::ostream                &text,
                      const StudyParameters       &study,
                      const std::vector<StudyRun> &runs,
                      const std::vector<Series>   &all_series)
    {
      const auto sweeps = study.sweeps();
      if (study.refined() < sweeps.size())
        for (const Series &series : all_series)
          if (!std::isnan(series.order))
            {
              char digits[20];
              std::snprintf(digits, sizeof(digits), "%.2f", series.order);
              text << "* Order in " << sweeps[study.refined()].heading()
                   << (series.name.empty() ? "" : ", " + series.name) << ": "
                   << digits << " (least squares over the series).\n";
            }

      std::vector<const StudyRun *> front;
      for (const StudyRun &run : runs)
        if (run.on_front)
          front.push_back(&run);
      std::sort(front.begin(), front.end(), [](const auto *a, const auto *b) {
        return a->cpu_time < b->cpu_time;
      });
      if (!front.empty())
        text << "* Pareto front, from fast to accurate:";
      for (std::size_t i = 0; i < front.size(); ++i)
        text << (i == 0 ? " " : "; ")
             << combination_text(sweeps, front[i]->values) << " ("
             << cell_text(Value(front[i]->error), "error ") << " in "
             << cell_text(Value(front[i]->cpu_time), "cpu time") << " s)";
      text << (front.empty() ? "" : ".\n");
    }
  } // namespace



  void write_csv(const std::string           &file,
                 const StudyParameters       &study,
                 const std::vector<StudyRun> &runs)
  {
    const auto               all = columns(study, runs);
    std::vector<std::string> headings;
    for (const Column &column : all)
      headings.push_back(column.heading);
    const std::string fresh = file + ".new";
    {
      ResultTable table(fresh, headings);
      for (std::size_t row = 0; row < runs.size(); ++row)
        {
          std::vector<Value> cells;
          for (const Column &column : all)
            cells.push_back(column.cells[row]);
          table.add_row(cells);
        }
    }
    std::filesystem::rename(fresh, file);
  }



  std::string report_text(const StudyParameters       &study,
                          const std::vector<StudyRun> &runs,
                          const std::vector<Series>   &all_series,
                          const std::string           &picture)
  {
    std::ostringstream text;
    text << "# " << study.title << "\n\n"
         << study.compare.quantity_in_words() << ", "
         << reference_in_words(study.compare) << ". Scene: "
         << std::filesystem::path(study.scene).filename().string()
         << (study.settings.empty() ? "" : ", with " + study.settings)
         << ". CPU time without start-up, one core.\n\n"
         << markdown_table(columns(study, runs), runs) << '\n';
    put_findings(text, study, runs, all_series);
    if (!picture.empty())
      text << "\n![" << study.title << "](" << picture << ")\n";
    return text.str();
  }
} // namespace demold

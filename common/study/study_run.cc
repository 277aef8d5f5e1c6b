// SPDX-License-Identifier: LGPL-2.1-or-later
// One run of a study: what was set, how it ended, what it gave.
#include "study/study_run.h"

#include "base/nearest_names.h"
#include "base/parameter_error.h"
#include "base/parameter_file.h"
#include "output/summary.h"
#include "study/child_process.h"
#include "study/csv_columns.h"
#include "study/study_parameters.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>

namespace demold
{
  namespace
  {
    namespace fs = std::filesystem;
    using nlohmann::json;

    json read_json(const fs::path &file)
    {
      std::ifstream in(file);
      json          object = json::parse(in, nullptr, false);
      return object.is_object() ? object : json();
    }



    double number_in(const json &object, const std::string &key)
    {
      const auto entry = object.find(key);
      return entry != object.end() && entry->is_number() ?
               entry->get<double>() :
               StudyRun::unknown;
    }



    std::string text_in(const json &object, const std::string &key)
    {
      const auto entry = object.find(key);
      if (entry == object.end() || entry->is_null())
        return "";
      return entry->is_string() ? entry->get<std::string>() : entry->dump();
    }



    /// What a run said before it ended: the line with its complaint, or the
    /// last one.
    std::string last_words(const fs::path &folder)
    {
      std::ifstream in(folder / "log.txt");
      std::string   words;
      for (std::string line; std::getline(in, line);)
        {
          const std::string text = trimmed(line);
          for (const std::string mark : {"Bad input: ", "Gave up: "})
            if (text.rfind(mark, 0) == 0)
              return text.substr(mark.size());
          if (!text.empty())
            words = text;
        }
      return words;
    }



    void read_status(StudyRun &run, const json &summary, const json &outcome)
    {
      const int code   = outcome.value("exit code", 0);
      const int signal = outcome.value("signal", 0);
      run.completed    = code == 0 && signal == 0 && !summary.is_null();
      run.status       = text_in(summary, "status");
      run.reason       = text_in(summary, "reason");
      if (run.completed && run.status.empty())
        run.status = "completed";
      if (run.completed)
        return;

      const std::string words = last_words(run.folder);
      if (signal != 0)
        {
          run.status = "killed";
          run.reason = std::string("signal ") + std::to_string(signal) + " (" +
                       strsignal(signal) + ")";
          return;
        }
      if (code == 0)
        run.reason = "ended without summary.json";
      else if (run.reason.empty())
        run.reason =
          words.empty() ? "exit code " + std::to_string(code) : words;
      if (code == 2)
        run.status = "bad input";
      else if (code == 127 && words.empty())
        run.reason = "the program could not be started";
      if (run.status.empty() || code == 0 || code == 127)
        run.status = code == 1 ? "gave up" : "failed";
    }



    double from_summary(const json &summary, const StudyParameters &study)
    {
      const std::string &key = study.compare.quantity;
      if (!summary.contains(key))
        {
          std::vector<std::string> keys;
          for (const auto &entry : summary.items())
            keys.push_back(entry.key());
          throw ExcParameter("Compare/quantity",
                             "must be an entry of summary.json; got \"" + key +
                               "\". " + nearest_names_sentence(key, keys));
        }
      return number_in(summary, key);
    }



    /// The number of a column; if there is none, @p reason says why.
    double from_table(const StudyRun        &run,
                      const StudyParameters &study,
                      std::string           &reason)
    {
      const Comparison &compare = study.compare;
      const CsvText     table((fs::path(run.folder) / compare.table).string());
      if (table.header.empty())
        throw ExcParameter("Compare/table",
                           "must be a csv table that the runs write; there is "
                           "no \"" +
                             compare.table + "\" in " + run.folder + ".");
      const auto require = [&table](const std::string &column,
                                    const std::string &path) {
        if (!table.has(column))
          throw ExcParameter(path,
                             "must be a column of the table; got \"" + column +
                               "\". " +
                               nearest_names_sentence(column, table.header));
      };
      require(compare.quantity, "Compare/quantity");
      auto column = table.numbers(compare.quantity);
      if (compare.take == "at")
        {
          require(compare.at_column, "Compare/at column");
          const double place = evaluate_formula(compare.at_value,
                                                study.symbols(run.values),
                                                "Compare/at value");
          const double found =
            value_at(table.numbers(compare.at_column), column, place);
          if (std::isnan(found))
            reason =
              compare.at_column + " does not reach " + std::to_string(place);
          return found;
        }
      if (compare.take == "end")
        return column.empty() ? StudyRun::unknown : column.back();
      column.erase(std::remove_if(column.begin(),
                                  column.end(),
                                  [](double x) { return std::isnan(x); }),
                   column.end());
      if (column.empty())
        return StudyRun::unknown;
      return compare.take == "largest" ?
               *std::max_element(column.begin(), column.end()) :
               *std::min_element(column.begin(), column.end());
    }



    /// Characters every file system takes, and none that is hidden or long.
    std::string folder_name(const std::vector<Sweep> &sweeps,
                            const Combination        &values)
    {
      std::string name;
      for (const char c : combination_text(sweeps, values))
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '+')
          name += c;
        else if (!name.empty() && name.back() != '-')
          name += '-';
        else if (c == '-' && name.size() > 1) // a minus sign
          name += 'm';
      return name.substr(0, 120);
    }
  } // namespace



  std::vector<StudyRun> planned_runs(const StudyParameters &study,
                                     const std::string     &output)
  {
    const auto            sweeps = study.sweeps();
    std::vector<StudyRun> runs;
    std::set<std::string> names;
    for (const auto &values : combinations(sweeps))
      {
        std::string name = folder_name(sweeps, values);
        while (!names.insert(name).second)
          name += "+";
        StudyRun run;
        run.values = values;
        run.folder = (fs::path(output) / "runs" / name).string();
        run.also.resize(split_list(study.compare.also, ';').size());
        runs.push_back(run);
      }
    return runs;
  }



  void read_results(StudyRun &run, const StudyParameters &study)
  {
    const fs::path folder  = run.folder;
    const json     summary = read_json(folder / "summary.json");
    json           outcome = read_json(folder / "outcome.json");
    if (outcome.is_null())
      outcome = json::object();
    read_status(run, summary, outcome);

    run.cpu_time = number_in(summary, "cpu time [s]");
    if (std::isnan(run.cpu_time)) // with its start-up: the best there is
      run.cpu_time = number_in(outcome, "cpu time [s]");
    run.n_unknowns = number_in(summary, "degrees of freedom");
    if (!run.completed)
      return;

    std::size_t i = 0;
    for (const auto &key : split_list(study.compare.also, ';'))
      run.also[i++] = text_in(summary, key);
    std::string reason = "has no number for " + study.compare.quantity;
    run.quantity       = study.compare.take == "summary" ?
                           from_summary(summary, study) :
                           from_table(run, study, reason);
    if (std::isnan(run.quantity))
      run.reason = reason;
  }



  void write_outcome(const StudyRun &run, const ChildEnd &end)
  {
    Summary outcome;
    outcome.set("exit code", end.exit_code);
    outcome.set("signal", end.signal);
    outcome.set("cpu time [s]", end.cpu_time);
    outcome.write((fs::path(run.folder) / "outcome.json").string());
  }



  bool has_results(const StudyRun &run)
  {
    const json summary = read_json(fs::path(run.folder) / "summary.json");
    const json outcome = read_json(fs::path(run.folder) / "outcome.json");
    return !summary.is_null() &&
           (!outcome.is_null() ||
            text_in(summary, "status").rfind("completed", 0) == 0);
  }
} // namespace demold

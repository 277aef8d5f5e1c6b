// SPDX-License-Identifier: LGPL-2.1-or-later
// What a study file says: scene, sweeps, quantity, reference, refinement.
#include "study/study_parameters.h"

#include "base/parameter_error.h"
#include "base/parameter_file.h"

#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <set>

namespace demold
{
  using namespace dealii;

  void Comparison::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("quantity",
                      quantity,
                      "entry of summary.json or column of the table, with its "
                      "unit");
    prm.add_parameter("take",
                      take,
                      "where from: summary.json, or from the column its last, "
                      "largest or smallest value, or the one at a place",
                      Patterns::Selection("summary|end|largest|smallest|at"));
    prm.add_parameter("table",
                      table,
                      "csv table in the output folder of a run that has the "
                      "column");
    prm.add_parameter("at column",
                      at_column,
                      "column of the table that says where \"at\" is");
    prm.add_parameter("at value",
                      at_value,
                      "value of that column, a number or a formula; between "
                      "rows the quantity is linear");
    prm.add_parameter("also list",
                      also,
                      "further entries of summary.json for the table, "
                      "separated by semicolons");
    prm.add_parameter("reference",
                      reference,
                      "what the quantity is compared with; finest: another run "
                      "of the study, see Refinement",
                      Patterns::Selection("none|closed form|value|finest"));
    prm.add_parameter("closed form",
                      closed_form,
                      "formula in the symbols of the sweeps and the "
                      "definitions");
    prm.add_parameter("definitions",
                      definitions,
                      "names for parts of formulas, each may use those before "
                      "it: a = 1; b = 2*a");
    prm.add_parameter("value",
                      value,
                      "reference value, in the quantity's unit");
    prm.add_parameter("finest among",
                      among,
                      "which runs the finest is sought in",
                      Patterns::Selection("all runs|own series"));
    prm.add_parameter("error",
                      measure,
                      "difference over the reference, or the difference",
                      Patterns::Selection("relative|absolute"));
    prm.add_parameter("round-off",
                      round_off,
                      "errors below have no order",
                      Patterns::Double(0.));
  }



  void Comparison::check() const
  {
    if (quantity.empty())
      throw ExcParameter("Compare/quantity",
                         "must name an entry of summary.json or a column of a "
                         "table; got nothing.");
    if (reference == "closed form" && closed_form.empty())
      throw ExcParameter("Compare/closed form",
                         "must be given for Compare/reference = closed form; "
                         "got nothing.");
    if (reference == "value" && measure == "relative" && value == 0.)
      throw ExcParameter("Compare/value",
                         "must not be 0 for Compare/error = relative; got 0. "
                         "Take Compare/error = absolute.");
  }



  std::string Comparison::error_heading() const
  {
    const auto bracket = quantity.find('[');
    if (measure == "absolute" && bracket != std::string::npos)
      return "error " + quantity.substr(bracket);
    return "error [-]";
  }



  std::string Comparison::quantity_in_words() const
  {
    if (take == "summary")
      return quantity;
    if (take == "at")
      return quantity + " of " + table + " at " + at_column + " = " + at_value;
    return (take == "end" ? "last " : take + " ") + quantity + " of " + table;
  }



  void StudyParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("title", title, "of table and picture; empty: the file");
    prm.add_parameter("scene file",
                      scene,
                      "scene to be run, sought beside this file first",
                      Patterns::Anything(),
                      true);
    prm.add_parameter("step",
                      step,
                      "program that runs it; empty: the one of the scene's "
                      "folder");
    prm.add_parameter("program file",
                      program,
                      "another program with the options of a step; empty: the "
                      "step");
    prm.add_parameter("settings",
                      settings,
                      "entries of the scene for all runs, separated by "
                      "semicolons: Body/size=2, 8; element=q2");
    prm.add_parameter("fields",
                      fields,
                      "let runs write fields and regular checkpoints, which "
                      "take time and disk");
    prm.add_parameter("runs at a time",
                      runs_at_a_time,
                      "on one core each; more than there are cores distorts "
                      "wall times",
                      Patterns::Integer(1, 1024));
    for (unsigned int i = 0; i < max_sweeps; ++i)
      {
        all_sweeps[i].section = "Sweep " + std::to_string(i + 1);
        prm.enter_subsection(all_sweeps[i].section);
        all_sweeps[i].add_parameters(prm);
        prm.leave_subsection();
      }
    prm.enter_subsection("Compare");
    compare.add_parameters(prm);
    prm.leave_subsection();
    prm.enter_subsection("Refinement");
    prm.add_parameter("sweep",
                      refined_sweep,
                      "number of the sweep that refines, for observed orders; "
                      "all others make series; 0: none does",
                      Patterns::Integer(0, max_sweeps));
    prm.add_parameter("finest",
                      finest,
                      "which of its values is the most accurate one",
                      Patterns::Selection(
                        "last value|smallest value|largest value"));
    prm.leave_subsection();
  }



  void StudyParameters::check() const
  {
    const auto used = sweeps();
    if (used.empty())
      throw ExcParameter("Sweep 1/entry",
                         "must name an entry of the scene; got nothing to "
                         "sweep.");
    std::set<std::string> headings, names, entries;
    for (const Sweep &sweep : used)
      {
        sweep.check();
        if (!entries.insert(sweep.entry).second)
          throw ExcParameter(sweep.section + "/entry",
                             "\"" + sweep.entry +
                               "\" is swept by another section already.");
        if (!headings.insert(sweep.heading()).second)
          throw ExcParameter(sweep.section + "/label",
                             "must differ from those of other sweeps; got \"" +
                               sweep.heading() + "\" twice.");
        const std::string name = sweep.name_in_formulas();
        if (!is_symbol(name) || name == "pi" || !names.insert(name).second)
          throw ExcParameter(sweep.section + "/symbol",
                             "must be a name of letters, digits and _, not pi, "
                             "used once; got \"" +
                               name + "\".");
        const unsigned int n = sweep.paired_with;
        if (n > 0 && (!all_sweeps[n - 1].is_used() ||
                      all_sweeps[n - 1].paired_with > 0 ||
                      all_sweeps[n - 1].section == sweep.section))
          throw ExcParameter(sweep.section + "/paired with",
                             "must be the number of another sweep that is used "
                             "and not paired itself; got " +
                               std::to_string(n) + ".");
      }
    if (refined_sweep > 0 && !all_sweeps[refined_sweep - 1].is_used())
      throw ExcParameter("Refinement/sweep",
                         "must be the number of a sweep that is used, or 0; "
                         "got " +
                           std::to_string(refined_sweep) + ".");
    compare.check();
    if (compare.reference == "finest" && refined_sweep == 0)
      throw ExcParameter("Refinement/sweep",
                         "must name a sweep for Compare/reference = finest; "
                         "got 0.");
    fixed_settings();

    for (const auto &values : combinations(used))
      {
        const Symbols known = symbols(values);
        if (compare.reference == "closed form")
          evaluate_formula(compare.closed_form, known, "Compare/closed form");
        if (compare.take == "at")
          evaluate_formula(compare.at_value, known, "Compare/at value");
      }
  }



  std::vector<Sweep> StudyParameters::sweeps() const
  {
    std::vector<Sweep> used;
    for (const Sweep &sweep : all_sweeps)
      if (sweep.is_used())
        used.push_back(sweep);
    return used;
  }



  std::size_t StudyParameters::refined() const
  {
    std::size_t position = 0;
    for (const Sweep &sweep : sweeps())
      {
        if (sweep.section == "Sweep " + std::to_string(refined_sweep))
          break;
        ++position;
      }
    return position;
  }



  bool StudyParameters::varies_in_series(const std::size_t s) const
  {
    const auto used   = sweeps();
    const auto leader = [&](const Sweep &sweep) {
      return sweep.paired_with > 0 ?
               "Sweep " + std::to_string(sweep.paired_with) :
               sweep.section;
    };
    return refined() < used.size() &&
           leader(used[s]) == leader(used[refined()]);
  }



  Symbols StudyParameters::symbols(const Combination &values) const
  {
    Symbols    known;
    const auto used = sweeps();
    for (std::size_t s = 0; s < used.size(); ++s)
      {
        const double number = first_number(values[s]);
        if (!std::isnan(number)) // words are no numbers: unknown in formulas
          known[used[s].name_in_formulas()] = number;
      }
    return with_definitions(known, compare.definitions, "Compare/definitions");
  }



  std::vector<std::pair<std::string, std::string>>
  StudyParameters::fixed_settings() const
  {
    std::vector<std::pair<std::string, std::string>> list;
    for (const auto &setting : split_list(settings, ';'))
      {
        const auto equals = setting.find('=');
        if (equals == std::string::npos || equals == 0)
          throw ExcParameter("settings",
                             "must be a list such as \"Body/size=2, 8; "
                             "element=q2\"; got \"" +
                               setting + "\".");
        list.emplace_back(trimmed(setting.substr(0, equals)),
                          trimmed(setting.substr(equals + 1)));
      }
    return list;
  }
} // namespace demold

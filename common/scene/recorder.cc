// SPDX-License-Identifier: LGPL-2.1-or-later
// What a run leaves behind: history, summary, plots, console lines.
#include "scene/recorder.h"

#include "output/plots.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace demold
{
  namespace
  {
    /// A quasi-static increment that loses more than this share of the largest
    /// ledger entry while bonds break or nodes leave the mould has jumped.
    constexpr double jump_share = 2e-3;

    /// The same for excursions of a path, whose energy is known.
    constexpr double smallest_jump = 1e-6;
  } // namespace

  Recorder::Recorder(const RunContext &context,
                     const bool        has_interface,
                     const bool        has_path)
    : context(context)
    , has_interface(has_interface)
    , has_path(has_path)
    , is_first(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    , progress(std::cout, context.quiet)
  {}

  std::vector<std::string> Recorder::column_names() const
  {
    std::vector<std::string> names = {"time [s]",
                                      "opening [mm]",
                                      "force [N]",
                                      "bonded area [mm^2]",
                                      "touching area [mm^2]"};
    for (const std::string &entry : Energies::names())
      names.push_back(entry + " [mJ]");
    for (const char *name : {"released energy [mJ]",
                             "energy gap [mJ]",
                             "newton iterations",
                             "rejected increments",
                             "strategy"})
      names.emplace_back(name);
    if (has_path)
      for (const char *name : {"point",
                               "constraint",
                               "negative pivots",
                               "sign of the determinant",
                               "smallest eigenvalue [N/mm]"})
        names.emplace_back(name);
    return names;
  }

  void Recorder::restart()
  {
    if (!is_first)
      return;
    table =
      std::make_unique<ResultTable>(context.output_folder + "/history.csv",
                                    column_names(),
                                    context.restart_output + "/history.csv",
                                    static_cast<unsigned int>(rows_saved));
  }

  void Recorder::find_jump(const Observation &now)
  {
    const double lost    = now.energies.gap() - last.energies.gap();
    const bool   loosens = now.energies.adhesion > last.energies.adhesion ||
                         now.closed < last.closed;
    if (now.strategy != "quasi-static" || lost <= jump_share * largest_entry ||
        !loosens)
      return;
    released += lost;
    unexplained += lost;
    ++n_jumps;
    char text[120];
    std::snprintf(text,
                  sizeof(text),
                  "jump: %.4g mJ released between openings %.4g and %.4g mm",
                  lost,
                  last.opening,
                  now.opening);
    progress.note(text);
  }

  void Recorder::count_excursion(const Observation &now)
  {
    // An excursion that comes back the way it went is none.
    if (!now.path || now.path->kind != "jump" ||
        std::abs(now.path->released) + now.path->damped <=
          smallest_jump * largest_entry)
      return;
    released += now.path->released + now.path->damped;
    damped += now.path->damped;
    ++n_jumps;
    char text[120];
    std::snprintf(
      text,
      sizeof(text),
      "jump: the excursion to opening %.4g mm has released %.4g mJ, "
      "dashpots took %.4g",
      now.opening,
      now.path->released,
      now.path->damped);
    progress.note(text);
  }

  std::vector<ResultTable::Value> Recorder::row(const Observation &now) const
  {
    std::vector<ResultTable::Value> row = {now.time,
                                           now.opening,
                                           now.force,
                                           now.bonded,
                                           now.closed};
    for (const double e : now.energies.as_array())
      row.emplace_back(e);
    row.emplace_back(released);
    row.emplace_back(now.energies.gap() - unexplained);
    row.emplace_back(static_cast<double>(now.iterations));
    row.emplace_back(static_cast<double>(now.rejected));
    row.emplace_back(now.strategy);
    if (has_path)
      {
        const PathPoint point = now.path.value_or(PathPoint());
        row.emplace_back(point.kind);
        row.emplace_back(point.constraint);
        row.emplace_back(static_cast<double>(point.stability.negative_pivots));
        row.emplace_back(static_cast<double>(point.stability.determinant_sign));
        row.emplace_back(point.stability.smallest_eigenvalue);
      }
    return row;
  }

  void Recorder::record(const Observation &now)
  {
    for (const double e : now.energies.as_array())
      largest_entry = std::max(largest_entry, std::abs(e));
    find_jump(now);
    count_excursion(now);
    largest_gap =
      std::max(largest_gap, std::abs(now.energies.gap() - unexplained));
    largest_kinetic = std::max(largest_kinetic, now.energies.kinetic);
    if (now.force > peak_force)
      {
        kinetic_to_peak = largest_kinetic;
        entry_to_peak   = largest_entry;
        peak_force      = now.force;
        opening_at_peak = now.opening;
      }
    largest_stretch = std::max(largest_stretch, now.stretch);
    largest_tension = std::max(largest_tension, now.tension);

    if (!table && is_first)
      table =
        std::make_unique<ResultTable>(context.output_folder + "/history.csv",
                                      column_names());
    rows_saved += 1.;
    if (now.strategy == "dynamics" || now.strategy == "explicit dynamics")
      with_inertia += 1.;
    if (table)
      table->add_row(row(now));
    IncrementLine line;
    line.time       = now.time;
    line.opening    = now.opening;
    line.force      = now.force;
    line.iterations = now.iterations;
    if (has_interface && now.area > 0.)
      line.bonded_fraction = now.bonded / now.area;
    line.strategy = now.path ? now.path->constraint : now.strategy;
    line.done     = now.done;
    progress.print(line);
    last = now;
  }

  double Recorder::energy_balance_error() const
  {
    // Below a femtojoule there is nothing but round-off to balance.
    return largest_entry > 1e-12 ? largest_gap / largest_entry : 0.;
  }

  double Recorder::kinetic_share_to_peak() const
  {
    return entry_to_peak > 1e-12 ? kinetic_to_peak / entry_to_peak : 0.;
  }

  void Recorder::summarise(Summary &summary) const
  {
    const Energies &e = last.energies;
    summary.set("peak force [N]", peak_force);
    summary.set("opening at peak [mm]", opening_at_peak);
    summary.set("opening at end [mm]", last.opening);
    summary.set("force at end [N]", last.force);
    // What a machine does: along a path it would miss the way back.
    summary.set("work of demolding [mJ]",
                e.external + released - unexplained - damped);
    summary.set("adhesion dissipation [mJ]", e.adhesion);
    summary.set("friction dissipation [mJ]", e.friction);
    summary.set("viscous dissipation [mJ]", e.viscous);
    summary.set("impact dissipation [mJ]", e.impact);
    summary.set("regularisation dissipation [mJ]", e.regularisation);
    summary.set("algorithmic dissipation [mJ]", e.algorithmic);
    summary.set("stored energy [mJ]", e.stored);
    summary.set("kinetic energy [mJ]", e.kinetic);
    summary.set("released energy [mJ]", released);
    summary.set("jumps", n_jumps);
    summary.set("share of increments with inertia [-]",
                rows_saved > 0. ? with_inertia / rows_saved : 0.);
    summary.set("kinetic share up to the peak [-]", kinetic_share_to_peak());
    summary.set("largest kinetic share [-]",
                largest_entry > 1e-12 ? largest_kinetic / largest_entry : 0.);
    summary.set("largest principal stretch [-]", largest_stretch);
    summary.set("largest principal tension [MPa]", largest_tension);
    summary.set("energy balance error [-]", energy_balance_error());
    if (has_interface)
      summary.set("bonded area left [mm^2]", last.bonded);
  }

  void Recorder::note(const std::string &text)
  {
    progress.note(text);
  }

  void Recorder::print(const Summary &summary)
  {
    progress.print(summary);
  }

  void
  Recorder::draw(const std::vector<std::pair<std::string, double>> &times) const
  {
    if (!is_first)
      return;
    std::vector<std::string> energies;
    for (const std::string &entry : Energies::names())
      energies.push_back(entry + " [mJ]");
    const std::string problem = draw_plots(context.output_folder,
                                           {{"force-over-opening",
                                             "Force over opening",
                                             "opening [mm]",
                                             {"force [N]"},
                                             "force [N]"},
                                            {"energies-over-opening",
                                             "Energies over opening",
                                             "opening [mm]",
                                             energies,
                                             "energy [mJ]"}},
                                           times);
    if (!problem.empty() && !context.quiet)
      std::cout << problem << std::endl;
  }

  std::vector<double> Recorder::save() const
  {
    std::vector<double> values = {rows_saved,
                                  peak_force,
                                  opening_at_peak,
                                  largest_entry,
                                  largest_gap,
                                  released,
                                  static_cast<double>(n_jumps),
                                  last.opening,
                                  largest_stretch,
                                  largest_tension,
                                  unexplained,
                                  with_inertia,
                                  damped,
                                  largest_kinetic,
                                  kinetic_to_peak,
                                  entry_to_peak};
    for (const double e : last.energies.as_array())
      values.push_back(e);
    return values;
  }

  void Recorder::load(const std::vector<double> &values)
  {
    rows_saved      = values.at(0);
    peak_force      = values.at(1);
    opening_at_peak = values.at(2);
    largest_entry   = values.at(3);
    largest_gap     = values.at(4);
    released        = values.at(5);
    n_jumps         = static_cast<unsigned int>(values.at(6));
    last.opening    = values.at(7);
    largest_stretch = values.at(8);
    largest_tension = values.at(9);
    unexplained     = values.at(10);
    with_inertia    = values.at(11);
    damped          = values.at(12);
    largest_kinetic = values.at(13);
    kinetic_to_peak = values.at(14);
    entry_to_peak   = values.at(15);
    std::array<double, Energies::n_entries> e;
    std::copy_n(values.begin() + 16, e.size(), e.begin());
    last.energies = Energies::from_array(e);
  }
} // namespace demold

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

    std::vector<std::string> column_names()
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
      return names;
    }
  } // namespace

  Recorder::Recorder(const RunContext &context, const bool has_interface)
    : context(context)
    , has_interface(has_interface)
    , is_first(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    , progress(std::cout, context.quiet)
  {}

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

  void Recorder::record(const Observation &now)
  {
    const auto before = last.energies.as_array();
    const auto after  = now.energies.as_array();
    for (const double e : after)
      largest_entry = std::max(largest_entry, std::abs(e));

    const double lost = now.energies.gap() - last.energies.gap();
    if (now.strategy == "quasi-static" && lost > jump_share * largest_entry &&
        (after[4] > before[4] || now.closed < last.closed))
      {
        released += lost;
        ++n_jumps;
        char text[120];
        std::snprintf(text,
                      sizeof(text),
                      "jump: %.4g mJ released between openings %.4g and %.4g "
                      "mm",
                      lost,
                      last.opening,
                      now.opening);
        progress.note(text);
      }
    const double gap = now.energies.gap() - released;
    largest_gap      = std::max(largest_gap, std::abs(gap));
    if (now.force > peak_force)
      {
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
    if (table)
      {
        std::vector<ResultTable::Value> row = {now.time,
                                               now.opening,
                                               now.force,
                                               now.bonded,
                                               now.closed};
        for (const double e : after)
          row.emplace_back(e);
        row.emplace_back(released);
        row.emplace_back(gap);
        row.emplace_back(static_cast<double>(now.iterations));
        row.emplace_back(static_cast<double>(now.rejected));
        row.emplace_back(now.strategy);
        table->add_row(row);
      }
    IncrementLine line;
    line.time       = now.time;
    line.opening    = now.opening;
    line.force      = now.force;
    line.iterations = now.iterations;
    if (has_interface && now.area > 0.)
      line.bonded_fraction = now.bonded / now.area;
    line.strategy = now.strategy;
    line.done     = now.done;
    progress.print(line);
    last = now;
  }

  double Recorder::energy_balance_error() const
  {
    // Below a femtojoule there is nothing but round-off to balance.
    return largest_entry > 1e-12 ? largest_gap / largest_entry : 0.;
  }

  void Recorder::summarise(Summary &summary) const
  {
    const Energies &e = last.energies;
    summary.set("peak force [N]", peak_force);
    summary.set("opening at peak [mm]", opening_at_peak);
    summary.set("opening at end [mm]", last.opening);
    summary.set("force at end [N]", last.force);
    summary.set("work of demolding [mJ]", e.external);
    summary.set("adhesion dissipation [mJ]", e.adhesion);
    summary.set("friction dissipation [mJ]", e.friction);
    summary.set("viscous dissipation [mJ]", e.viscous);
    summary.set("impact dissipation [mJ]", e.impact);
    summary.set("algorithmic dissipation [mJ]", e.algorithmic);
    summary.set("stored energy [mJ]", e.stored);
    summary.set("kinetic energy [mJ]", e.kinetic);
    summary.set("released energy [mJ]", released);
    summary.set("jumps", n_jumps);
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
                                  largest_tension};
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
    std::array<double, Energies::n_entries> e;
    std::copy_n(values.begin() + 10, e.size(), e.begin());
    last.energies = Energies::from_array(e);
  }
} // namespace demold

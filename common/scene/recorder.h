// SPDX-License-Identifier: LGPL-2.1-or-later
// What a run leaves behind: history, summary, plots, console lines.
#ifndef demold_scene_recorder_h
#define demold_scene_recorder_h

#include "base/run_step.h"
#include "output/progress.h"
#include "output/result_table.h"
#include "output/summary.h"
#include "solution/strategy.h"
#include "weak_form/energies.h"

#include <memory>
#include <string>
#include <vector>

namespace demold
{
  /// What is known after an accepted increment, for the whole block.
  struct Observation
  {
    double       time    = 0.; ///< [s]
    double       opening = 0.; ///< [mm]
    double       force   = 0.; ///< [N] in the opening direction
    double       bonded  = 0.; ///< [mm^2]
    double       closed  = 0.; ///< [mm^2] under pressure
    double       area    = 0.; ///< [mm^2] of the slave surface
    double       stretch = 1.; ///< [-] largest principal one of a cell
    double       tension = 0.; ///< [MPa] largest principal Cauchy stress
    Energies     energies;
    unsigned int iterations = 0;
    unsigned int rejected   = 0;
    std::string  strategy;
    double       done = 0.; ///< share of the run

    std::optional<PathPoint> path; ///< of path following only
  };

  /// Keeps the running extremes, writes history.csv row by row, finds the
  /// jumps of quasi-static runs and closes the books at the end. A path is
  /// booked as it is, excursions included; what a machine would see released
  /// there is listed apart.
  class Recorder
  {
  public:
    Recorder(const RunContext &context, bool has_interface, bool has_path);

    /// Continues history.csv after the rows counted in the checkpoint.
    void restart();

    void record(const Observation &observation);

    /// Largest ledger gap over the largest entry so far [-].
    double energy_balance_error() const;

    /// Largest kinetic energy up to the peak force, over the largest ledger
    /// entry up to there [-]: what inertia adds before anything jumps.
    double kinetic_share_to_peak() const;

    /// Adds the results to @p summary.
    void summarise(Summary &summary) const;

    /// A remark on the console.
    void note(const std::string &text);

    void print(const Summary &summary);

    void draw(const std::vector<std::pair<std::string, double>> &times) const;

    /// State for checkpoints.
    std::vector<double> save() const;
    void                load(const std::vector<double> &values);

    unsigned int n_jumps = 0;

  private:
    std::vector<std::string>        column_names() const;
    std::vector<ResultTable::Value> row(const Observation &now) const;
    void                            find_jump(const Observation &now);
    void                            count_excursion(const Observation &now);

    const RunContext             context;
    const bool                   has_interface;
    const bool                   has_path;
    const bool                   is_first; ///< rank, the one that writes
    std::unique_ptr<ResultTable> table;
    Progress                     progress;
    Observation                  last;
    double                       peak_force = 0., opening_at_peak = 0.;
    double                       largest_entry = 0., largest_gap = 0.;
    double                       largest_kinetic = 0.; ///< [mJ]
    double                       kinetic_to_peak = 0., entry_to_peak = 0.;
    double                       released        = 0.; ///< [mJ] in jumps
    double                       unexplained     = 0.; ///< [mJ] of these
    double                       damped          = 0.; ///< [mJ] in dashpots
    double                       rows_saved      = 0.;
    double                       with_inertia    = 0.; ///< of these rows
    double                       largest_stretch = 1.; ///< [-]
    double                       largest_tension = 0.; ///< [MPa]
  };
} // namespace demold

#endif

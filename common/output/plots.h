// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures of history.csv, drawn by gnuplot from scripts the user keeps.
#ifndef demold_output_plots_h
#define demold_output_plots_h

#include <string>
#include <utility>
#include <vector>

namespace demold
{
  /// Curves over one column of history.csv.
  struct LinePlot
  {
    std::string name;  ///< of the files: "force-over-opening"
    std::string title; ///< "Demolding force"
    std::string x;     ///< column, with its unit, as it labels the axis
    std::vector<std::string> y;       ///< columns, one curve each
    std::string              y_label; ///< "force [N]"
  };

  /// Bars, longest time first: (what, [s]).
  using TimeBreakdown = std::vector<std::pair<std::string, double>>;

  /// The gnuplot script of @p plot, to be run in the output folder.
  std::string plot_script(const LinePlot &plot);

  /// The gnuplot script of the bars.
  std::string plot_script(const TimeBreakdown &times);

  /// Writes NAME.gp beside history.csv in @p output_folder for every plot and
  /// time-breakdown.gp, and draws plots/NAME.svg. Returns an empty text or what
  /// went wrong, for the console: pictures are a convenience, so a missing
  /// gnuplot never ends a run.
  std::string draw_plots(const std::string           &output_folder,
                         const std::vector<LinePlot> &plots,
                         const TimeBreakdown         &times);

  /// The first lines of every script: size, font and colours, the output file
  /// plots/NAME.svg and the title. For pictures of tables other than
  /// history.csv, whose commands follow.
  std::string plot_head(const std::string &name, const std::string &title);

  /// As draw_plots(), of scripts given as ("NAME.gp", text).
  std::string
  draw_scripts(const std::string &output_folder,
               const std::vector<std::pair<std::string, std::string>> &scripts);
} // namespace demold

#endif

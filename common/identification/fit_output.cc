// SPDX-License-Identifier: LGPL-2.1-or-later
// What all fits write in the same way.
#include "identification/fit_output.h"

#include "output/plots.h"
#include "output/summary.h"

#include <filesystem>
#include <iostream>
#include <sstream>

namespace demold
{
  namespace
  {
    std::string quoted(const std::string &text)
    {
      return "\"" + text + "\"";
    }



    /// The column, or nothing where the row belongs to another group.
    std::string values(const FitPlot     &plot,
                       const std::string &column,
                       const std::string &of)
    {
      const std::string value = "column(" + quoted(column) + ")";
      if (plot.group.empty())
        return "(" + value + ")";
      return "(strcol(" + quoted(plot.group) + ") eq " + quoted(of) + " ? " +
             value + " : NaN)";
    }
  } // namespace



  std::string extent(const DataFile &data, const std::string &rows)
  {
    return std::to_string(data.n_rows()) + " " + rows + " of " +
           std::filesystem::path(data.file).filename().string();
  }



  Summary summary_of_fit()
  {
    Summary summary;
    summary.set("status", "completed");
    summary.set("reason", "the data are fitted");
    return summary;
  }



  std::vector<std::string> source_comments(const std::vector<DataFile> &files)
  {
    std::vector<std::string> lines;
    for (const auto &data : files)
      {
        lines.push_back(
          "Data: " + std::filesystem::path(data.file).filename().string() +
          ".");
        for (const auto &source : data.source)
          lines.push_back("  " + source);
      }
    return lines;
  }



  std::string plot_script(const FitPlot &plot)
  {
    std::ostringstream script;
    script << plot_head(plot.name, plot.title)
           << "set datafile separator comma\n"
           // Groups leave gaps, which are not to be drawn over.
           << "set datafile missing NaN\n"
           << "set xlabel " << quoted(plot.x) << "\n"
           << "set ylabel " << quoted(plot.y_label) << "\n"
           << "set key below\n"
           << (plot.logarithmic_x ? "set logscale x\nset format x '%g'\n" : "")
           << (plot.logarithmic_y ? "set logscale y\nset format y '%g'\n" : "")
           << "plot ";
    const auto groups =
      plot.group.empty() ? std::vector<std::string>{""} : plot.group_values;
    unsigned int colour = 0;
    for (const auto &group : groups)
      for (const auto &[data, model] : plot.y)
        {
          const std::string label = group.empty() ? "" : group + ", ";
          const std::string x     = "using (column(" + quoted(plot.x) + ")):";
          script << (colour == 0 ? "" : ", \\\n     ") << "'fit.csv' " << x
                 << values(plot, data, group)
                 << " with points pointtype 7 pointsize 0.6 linetype "
                 << colour + 1 << " title " << quoted(label + data) << ", \\\n"
                 << "     'fit.csv' " << x << values(plot, model, group)
                 << " with lines linetype " << colour + 1 << " title "
                 << quoted(label + model);
          ++colour;
        }
    script << "\n";
    return script.str();
  }



  void finish_fit(const RunContext           &context,
                  const Summary              &summary,
                  const std::vector<FitPlot> &plots,
                  const std::string          &include)
  {
    const std::filesystem::path folder = context.output_folder;
    summary.write((folder / "summary.json").string());
    std::vector<std::pair<std::string, std::string>> scripts;
    for (const auto &plot : plots)
      scripts.emplace_back(plot.name + ".gp", plot_script(plot));
    const std::string complaint = draw_scripts(context.output_folder, scripts);
    if (context.quiet)
      return;
    summary.print(std::cout);
    if (!complaint.empty())
      std::cout << complaint << std::endl;
    if (!include.empty())
      std::cout << "Include file: " << (folder / include).string() << std::endl;
  }
} // namespace demold

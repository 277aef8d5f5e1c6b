// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables and pictures of a press cycle.
#include "cure/cure_cycle_output.h"

#include "output/plots.h"
#include "output/result_table.h"

#include <sstream>
#include <utility>

namespace demold
{
  namespace
  {
    struct Quantity
    {
      const char *name, *unit;
      double (*at)(const DepthHistory &, std::size_t);
    };

    const Quantity quantities[] = {
      {"temperature",
       "degC",
       [](const DepthHistory &h, const std::size_t i) {
         return h.temperature[i];
       }},
      {"f90",
       "-",
       [](const DepthHistory &h, const std::size_t i) {
         return h.state[i].f90;
       }},
      {"degree of cure", "-", [](const DepthHistory &h, const std::size_t i) {
         return h.degree[i];
       }}};



    std::string column(const Quantity &quantity, const std::string &where)
    {
      return std::string(quantity.name) + " " + where + " [" + quantity.unit +
             "]";
    }

    std::string at_depth(const double depth)
    {
      std::ostringstream text;
      text << "at " << depth << " mm";
      return text.str();
    }



    /// Cure over depth; profile.csv has the columns depth, T, T, f90, f90,
    /// alpha, alpha.
    std::string profile_script()
    {
      return plot_head("cure-over-depth",
                       "Cure over the depth from the mould side") +
             "set datafile separator comma\n"
             "set key below\n"
             "set xlabel 'depth [mm]'\n"
             "set ylabel 'f90, degree of cure [-]'\n"
             "set yrange [0:*]\n"
             "plot 'profile.csv' using 1:4 with lines title 'f90 at the "
             "opening', \\\n"
             "     '' using 1:5 with lines title 'f90 at the end', \\\n"
             "     '' using 1:6 with lines title 'degree of cure at the "
             "opening', \\\n"
             "     '' using 1:7 with lines title 'degree of cure at the "
             "end'\n";
    }
  } // namespace



  void write_cure_history(const std::string               &folder,
                          const std::vector<double>       &times,
                          const std::vector<DepthHistory> &histories)
  {
    std::vector<std::string> columns = {"time [s]"};
    for (const auto &quantity : quantities)
      for (const auto &history : histories)
        columns.push_back(column(quantity, at_depth(history.depth)));
    ResultTable table(folder + "/history.csv", columns);
    for (std::size_t i = 0; i < times.size(); ++i)
      {
        std::vector<ResultTable::Value> row = {times[i]};
        for (const auto &quantity : quantities)
          for (const auto &history : histories)
            row.push_back(quantity.at(history, i));
        table.add_row(row);
      }
  }



  void write_cure_profile(const std::string               &folder,
                          const std::size_t                opening,
                          const std::vector<DepthHistory> &profile)
  {
    std::vector<std::string> columns = {"depth [mm]"};
    for (const auto &quantity : quantities)
      for (const char *const when : {"at the opening", "at the end"})
        columns.push_back(column(quantity, when));
    ResultTable table(folder + "/profile.csv", columns);
    for (const auto &history : profile)
      {
        std::vector<ResultTable::Value> row = {history.depth};
        for (const auto &quantity : quantities)
          for (const std::size_t i : {opening, history.degree.size() - 1})
            row.push_back(quantity.at(history, i));
        table.add_row(row);
      }
  }



  std::string draw_cure_cycle(const std::string               &folder,
                              const std::vector<DepthHistory> &histories)
  {
    std::vector<std::pair<std::string, std::string>> scripts;
    const char *const titles[] = {"Temperature over the press cycle",
                                  "Equivalent curing time over t90",
                                  "Degree of cure"};
    const char *const names[]  = {"temperature-over-time",
                                  "f90-over-time",
                                  "degree-of-cure-over-time"};
    for (unsigned int q = 0; q < 3; ++q)
      {
        LinePlot plot;
        plot.name  = names[q];
        plot.title = titles[q];
        plot.x     = "time [s]";
        plot.y_label =
          std::string(quantities[q].name) + " [" + quantities[q].unit + "]";
        for (const auto &history : histories)
          plot.y.push_back(column(quantities[q], at_depth(history.depth)));
        scripts.emplace_back(plot.name + ".gp", plot_script(plot));
      }
    scripts.emplace_back("cure-over-depth.gp", profile_script());
    return draw_scripts(folder, scripts);
  }
} // namespace demold

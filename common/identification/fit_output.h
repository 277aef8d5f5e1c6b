// SPDX-License-Identifier: LGPL-2.1-or-later
// What all fits write in the same way.
#ifndef demold_identification_fit_output_h
#define demold_identification_fit_output_h

#include "base/data_file.h"
#include "base/run_step.h"

#include <string>
#include <utility>
#include <vector>

namespace demold
{
  class Summary;

  /// "25 frequencies of dma.csv", the rows being @p rows.
  std::string extent(const DataFile &data, const std::string &rows);

  /// A summary that begins with status and reason.
  Summary summary_of_fit();

  /// Where the data come from, as comments of an include file: the name of each
  /// file and its source lines.
  std::vector<std::string> source_comments(const std::vector<DataFile> &files);

  /// A picture over columns of fit.csv: data as points, model as lines.
  struct FitPlot
  {
    std::string name;  ///< of the files: "stress-over-stretch"
    std::string title; ///< "Nominal stress"
    std::string x;     ///< column
    std::string y_label;
    bool        logarithmic_x = false;
    bool        logarithmic_y = false;

    /// A curve for each value of this column; none: all rows are one curve.
    std::string              group;
    std::vector<std::string> group_values;

    /// Columns of data and model.
    std::vector<std::pair<std::string, std::string>> y;
  };

  /// The gnuplot script of @p plot, to be run in the output folder.
  std::string plot_script(const FitPlot &plot);

  /// Ends a fit: writes summary.json and the pictures, tells the console, also
  /// of the file @p include that a scene can include, if there is one.
  void finish_fit(const RunContext           &context,
                  const Summary              &summary,
                  const std::vector<FitPlot> &plots,
                  const std::string          &include);
} // namespace demold

#endif

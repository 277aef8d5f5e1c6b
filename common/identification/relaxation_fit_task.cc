// SPDX-License-Identifier: LGPL-2.1-or-later
// The task `relaxation fit`: Prony series from a curve in time.
#include "identification/relaxation_fit_task.h"

#include "base/parameter_error.h"
#include "identification/fit_output.h"
#include "identification/parameter_include.h"
#include "identification/prony_output.h"
#include "output/result_table.h"
#include "output/summary.h"

#include <deal.II/base/parameter_handler.h>

#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    const std::vector<DataColumn> columns{{"time [s]", DataColumn::increasing},
                                          {"relaxation modulus [MPa]",
                                           DataColumn::positive}};



    void write_fit(const std::string &folder,
                   const DataFile    &data,
                   const PronyCurve  &curve,
                   const PronySeries &series)
    {
      ResultTable table(
        folder + "/fit.csv",
        {"time [s]", "data [MPa]", "model [MPa]", "residual [MPa]"});
      for (unsigned int i = 0; i < data.n_rows(); ++i)
        {
          const double model = curve.model(series, i);
          table.add_row({data.columns[0][i],
                         data.columns[1][i],
                         model,
                         model - data.columns[1][i]});
        }
    }
  } // namespace



  void RelaxationFitTask::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Relaxation fit");
    prm.add_parameter("data file",
                      file,
                      "CSV with the columns \"" + columns[0].name +
                        "\", since the loading began, and \"" +
                        columns[1].name + "\", stress over the strain held");
    prm.add_parameter("ramp time",
                      ramp,
                      "over which the strain has grown linearly before it was "
                      "held [s]",
                      Patterns::Double(0.));
    prm.add_parameter("equilibrium modulus",
                      equilibrium,
                      "E_inf, if known from static tests; 0: fitted [MPa]",
                      Patterns::Double(0.));
    choice.add_parameters(prm, "Relaxation fit");
    prm.leave_subsection();
  }



  RelaxationFitTask::Data RelaxationFitTask::read() const
  {
    if (file.empty())
      throw ExcParameter("Relaxation fit/data file",
                         "a data file is needed; got none.");
    Data data;
    data.file       = read_data_file(file, columns);
    data.curve.ramp = ramp;
    for (unsigned int i = 0; i < data.file.n_rows(); ++i)
      {
        const double time  = data.file.columns[0][i],
                     value = data.file.columns[1][i];
        if (time < ramp)
          throw ExcDataFile(file,
                            data.file.lines[i],
                            "\"time [s]\" must not be before the end of the "
                            "ramp, " +
                              prm_number(ramp) + " s; got " + prm_number(time) +
                              " s. Leave out the ramp, or change "
                              "Relaxation fit/ramp time.");
        data.curve.points.push_back(
          {PronyQuantity::relaxation, time, value, choice.weight(value)});
      }
    choice.check({data.curve});
    return data;
  }



  void RelaxationFitTask::check() const
  {
    read();
  }



  std::string RelaxationFitTask::preview() const
  {
    const Data data = read();
    return "Fits a Prony series to the relaxation modulus: " +
           choice.in_words() + ".\n  " + extent(data.file, "times");
  }



  RunStatus RelaxationFitTask::run(const RunContext &context) const
  {
    const Data data = read();
    const auto outcome =
      choice.fit({data.curve}, {equilibrium > 0. ? equilibrium : -1.});
    const PronySeries &series = outcome.best.series[0];
    const std::string &folder = context.output_folder;

    write_fit(folder, data.file, data.curve, series);
    write_series(folder, {""}, {series});
    write_trials(folder, outcome.trials);
    outcome.best.report.write_correlations(folder + "/correlations.csv");
    ParameterInclude include = choice.material(series);
    include.comments         = source_comments({data.file});
    include.comments.push_back(outcome.best.report.identifiability());
    include.write(folder + "/material.prm");

    Summary summary = summary_of_fit();
    add_to_summary(choice, outcome, {""}, summary);
    summary.set("R2 [-]", [&] {
      std::vector<double> model;
      for (unsigned int i = 0; i < data.file.n_rows(); ++i)
        model.push_back(data.curve.model(series, i));
      return coefficient_of_determination(data.file.columns[1], model);
    }());

    FitPlot plot;
    plot.name          = "relaxation";
    plot.title         = "Relaxation modulus";
    plot.x             = "time [s]";
    plot.y_label       = "stress over strain [MPa]";
    plot.logarithmic_x = true;
    plot.y             = {{"data [MPa]", "model [MPa]"}};
    finish_fit(context, summary, {plot}, "material.prm");
    return RunStatus::completed;
  }
} // namespace demold

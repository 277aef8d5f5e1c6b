// SPDX-License-Identifier: LGPL-2.1-or-later
// The task `cure fit`: entries, rheometer curves, predictions.
#include "identification/cure_fit_task.h"

#include "base/parameter_error.h"
#include "identification/cure_fit_output.h"
#include "identification/fit_output.h"
#include "output/summary.h"

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    const std::vector<DataColumn> columns{{"time [s]", DataColumn::increasing},
                                          {"storage torque [dNm]",
                                           DataColumn::positive}};
  } // namespace



  void CureFitTask::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Cure fit");
    prm.add_parameter("law",
                      law,
                      "kinetics of the degree of cure [-]; han knows reversion",
                      Patterns::Selection(std::string(KamalSourour::name) +
                                          "|" + IsayevDeng::name + "|" +
                                          Han::name));
    prm.add_parameter("reference temperature",
                      reference_temperature,
                      "T_ref of t90 and of all rates [degC]",
                      Patterns::Double(-50., 400.));
    prm.add_parameter("predict at",
                      predicted,
                      "temperatures for which t90 is predicted [degC]");
    for (unsigned int i = 0; i < entries.size(); ++i)
      {
        prm.enter_subsection("Curve " + std::to_string(i + 1));
        prm.add_parameter("data file",
                          entries[i].file,
                          "CSV with the columns \"" + columns[0].name +
                            "\" and \"" + columns[1].name +
                            "\"; empty: no such curve");
        prm.add_parameter("temperature",
                          entries[i].temperature,
                          "T of the rheometer [degC]",
                          Patterns::Double(-50., 400.));
        prm.leave_subsection();
      }
    prm.leave_subsection();
  }



  CureFitTask::Data CureFitTask::read() const
  {
    Data data;
    for (unsigned int i = 0; i < entries.size(); ++i)
      {
        const Entry &entry = entries[i];
        if (entry.file.empty())
          continue;
        for (const auto &curve : data.curves)
          if (curve.temperature == entry.temperature)
            throw ExcParameter("Cure fit/Curve " + std::to_string(i + 1) +
                                 "/temperature",
                               "must differ from those of the other curves; "
                               "got " +
                                 curve_name(entry.temperature) + " twice.");
        // Four points are the least that can be interpolated.
        data.files.push_back(read_data_file(entry.file, columns, 4));
        const auto       &file = data.files.back();
        const std::string why_not =
          RheometerCurve::problem(file.columns[0], file.columns[1]);
        if (!why_not.empty())
          throw ExcDataFile(entry.file,
                            file.lines.back(),
                            "a rheometer curve " + why_not);
        data.curves.emplace_back(entry.temperature,
                                 file.columns[0],
                                 file.columns[1]);
      }
    if (data.curves.size() < 2)
      throw ExcParameter(
        "Cure fit/Curve 2/data file",
        "curves at two temperatures at least are needed; got " +
          std::to_string(data.curves.size()) + ".");
    for (const double temperature : predicted)
      if (!(temperature > -50. && temperature < 400.))
        throw ExcParameter("Cure fit/predict at",
                           "must lie between -50 and 400 degC; got " +
                             prm_number(temperature) + ".");
    return data;
  }



  void CureFitTask::check() const
  {
    read();
  }



  std::string CureFitTask::preview() const
  {
    const Data         data = read();
    std::ostringstream text;
    text << "Fits t90 over temperature and the kinetics " << law << " to:";
    for (unsigned int c = 0; c < data.curves.size(); ++c)
      text << "\n  " << curve_name(data.curves[c].temperature) << ", "
           << extent(data.files[c], "points");
    return text.str();
  }



  void CureFitTask::add_times(const std::vector<RheometerCurve> &curves,
                              Summary                           &summary) const
  {
    for (const unsigned int percent : {10, 50, 90})
      {
        const auto line =
          fit_cure_times(curves, .01 * percent, reference_temperature);
        const std::string t = "t" + std::to_string(percent);
        summary.set("activation energy from " + t + " [kJ/mol]",
                    line.law.activation_energy);
        summary.set("standard error of activation energy from " + t +
                      " [kJ/mol]",
                    line.energy_error);
        summary.set(t + " at " + curve_name(reference_temperature) + " [s]",
                    line.law.reference_value);
      }
    // What the line is worth where there was no curve.
    for (unsigned int c = 0; c < curves.size() && curves.size() > 2; ++c)
      {
        auto others = curves;
        others.erase(others.begin() + c);
        const double t = fit_cure_times(others, .9, reference_temperature)
                           .law(curves[c].temperature);
        summary.set("t90 at " + curve_name(curves[c].temperature) +
                      " predicted by the other curves over measured [-]",
                    t / curves[c].time_of(.9));
      }
  }



  void CureFitTask::add_predictions(const CureFit                     &fit,
                                    const CureFitResult               &result,
                                    const std::vector<RheometerCurve> &curves,
                                    Summary &summary) const
  {
    const auto line = fit_cure_times(curves, .9, reference_temperature);
    for (const double temperature : predicted)
      {
        const std::string what    = "t90 at " + curve_name(temperature);
        const auto        by_line = predict(line, temperature);
        summary.set(what + " by Arrhenius' line [s]", by_line.value);
        summary.set("standard error of " + what + " by Arrhenius' line [s]",
                    by_line.standard_error);
        if (line.n_points > 2)
          {
            // The line is in ln t: so is the interval.
            const double half = confidence_factor(.95, line.n_points - 2) *
                                line.prediction_error(temperature);
            summary.set("95 % lower bound of " + what + " [s]",
                        by_line.value * std::exp(-half));
            summary.set("95 % upper bound of " + what + " [s]",
                        by_line.value * std::exp(half));
          }
        const auto by_law = fit.t90(result, temperature);
        summary.set(what + " by the kinetics [s]", by_law.value);
        summary.set("standard error of " + what + " by the kinetics [s]",
                    by_law.standard_error);
      }
  }



  RunStatus CureFitTask::run(const RunContext &context) const
  {
    const Data         data = read();
    const CureFit      fit(law, data.curves, reference_temperature);
    const auto         result = fit.fit();
    const std::string &folder = context.output_folder;

    write_fit(folder, fit, result, data.curves);
    write_times(folder, data.curves);
    result.report.write_correlations(folder + "/correlations.csv");
    ParameterInclude include =
      cure_include(result.kinetics,
                   fit_cure_times(data.curves, .9, reference_temperature).law);
    include.comments = source_comments(data.files);
    include.comments.push_back(result.report.identifiability());
    include.write(folder + "/cure.prm");

    Summary summary = summary_of_fit();
    summary.set("law", law);
    add_times(data.curves, summary);
    add_predictions(fit, result, data.curves, summary);
    summary.set("rms of the degree of cure [-]", result.report.rms);
    for (unsigned int c = 0; c < data.curves.size(); ++c)
      summary.set("rms at " + curve_name(data.curves[c].temperature) + " [-]",
                  result.rms[c]);
    result.report.write("-", summary);
    summary.set("remaining slope [-]", result.slope);

    FitPlot plot;
    plot.name          = "degree-of-cure";
    plot.title         = "Degree of cure, " + law;
    plot.x             = "time [s]";
    plot.y_label       = "degree of cure [-]";
    plot.logarithmic_x = true;
    plot.group         = "curve";
    for (const auto &curve : data.curves)
      plot.group_values.push_back(curve_name(curve.temperature));
    plot.y = {{"data [-]", "model [-]"}};
    finish_fit(context, summary, {plot}, "cure.prm");
    return RunStatus::completed;
  }
} // namespace demold

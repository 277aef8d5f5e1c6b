// SPDX-License-Identifier: LGPL-2.1-or-later
// The task `dma fit`: Prony series from storage and loss moduli.
#include "identification/dma_fit_task.h"

#include "base/parameter_error.h"
#include "identification/parameter_include.h"
#include "identification/prony_output.h"
#include "output/result_table.h"
#include "output/summary.h"

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>

#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    const std::vector<DataColumn> columns{
      {"frequency [Hz]", DataColumn::positive},
      {"storage modulus [MPa]", DataColumn::positive},
      {"loss modulus [MPa]", DataColumn::positive}};

    std::string level_name(const double f90)
    {
      return "f90 " + prm_number(f90);
    }



    std::vector<std::string> level_names(const std::vector<double> &f90)
    {
      std::vector<std::string> names;
      for (const double level : f90)
        names.push_back(level_name(level));
      return names;
    }
  } // namespace



  void DmaFitTask::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Dma fit");
    choice.add_parameters(prm, "Dma fit");
    for (unsigned int i = 0; i < levels.size(); ++i)
      {
        prm.enter_subsection("Level " + std::to_string(i + 1));
        prm.add_parameter("data file",
                          levels[i].file,
                          "CSV with the columns \"" + columns[0].name +
                            "\", \"" + columns[1].name + "\", \"" +
                            columns[2].name + "\"; empty: no such level");
        prm.add_parameter("f90",
                          levels[i].f90,
                          "f90 t90-factor of the specimen [-]",
                          Patterns::Double(0.));
        prm.add_parameter("equilibrium modulus",
                          levels[i].equilibrium,
                          "E_inf, if known from static tests; 0: fitted [MPa]",
                          Patterns::Double(0.));
        prm.leave_subsection();
      }
    prm.leave_subsection();
  }



  DmaFitTask::Data DmaFitTask::read() const
  {
    Data data;
    for (unsigned int i = 0; i < levels.size(); ++i)
      {
        const Level &level = levels[i];
        if (level.file.empty())
          continue;
        const std::string path = "Dma fit/Level " + std::to_string(i + 1);
        if (!data.f90.empty() && !(level.f90 > data.f90.back()))
          throw ExcParameter(path + "/f90",
                             "must exceed that of the level before, " +
                               prm_number(data.f90.back()) + "; got " +
                               prm_number(level.f90) + ".");
        data.files.push_back(read_data_file(level.file, columns));
        data.f90.push_back(level.f90);
        data.equilibrium.push_back(level.equilibrium > 0. ? level.equilibrium :
                                                            -1.);
        PronyCurve  curve;
        const auto &c = data.files.back().columns;
        for (unsigned int k = 0; k < c[0].size(); ++k)
          for (const unsigned int q : {1, 2})
            curve.points.push_back(
              {q == 1 ? PronyQuantity::storage : PronyQuantity::loss,
               2. * numbers::PI * c[0][k],
               c[q][k],
               choice.weight(c[q][k])});
        data.curves.push_back(curve);
      }
    if (data.files.empty())
      throw ExcParameter("Dma fit/Level 1/data file",
                         "at least one level needs a data file; got none.");
    choice.check(data.curves);
    return data;
  }



  void DmaFitTask::check() const
  {
    read();
  }



  std::string DmaFitTask::preview() const
  {
    const Data         data = read();
    std::ostringstream text;
    text << "Fits a Prony series to E' and E'': " << choice.in_words() << ".";
    for (unsigned int c = 0; c < data.files.size(); ++c)
      text << "\n  " << level_name(data.f90[c]) << ", "
           << extent(data.files[c], "frequencies");
    return text.str();
  }



  std::vector<FitPlot>
  DmaFitTask::write_fit(const std::string              &folder,
                        const Data                     &data,
                        const std::vector<PronySeries> &series) const
  {
    ResultTable table(folder + "/fit.csv",
                      {"level",
                       "frequency [Hz]",
                       "storage data [MPa]",
                       "storage model [MPa]",
                       "storage residual [MPa]",
                       "loss data [MPa]",
                       "loss model [MPa]",
                       "loss residual [MPa]",
                       "tan psi data [-]",
                       "tan psi model [-]"});
    for (unsigned int c = 0; c < series.size(); ++c)
      for (unsigned int k = 0; k < data.files[c].n_rows(); ++k)
        {
          const auto  &column  = data.files[c].columns;
          const double storage = data.curves[c].model(series[c], 2 * k),
                       loss    = data.curves[c].model(series[c], 2 * k + 1);
          table.add_row({level_name(data.f90[c]),
                         column[0][k],
                         column[1][k],
                         storage,
                         storage - column[1][k],
                         column[2][k],
                         loss,
                         loss - column[2][k],
                         column[2][k] / column[1][k],
                         loss / storage});
        }

    FitPlot plot;
    plot.x             = "frequency [Hz]";
    plot.logarithmic_x = true;
    plot.group         = "level";
    plot.group_values  = level_names(data.f90);
    std::vector<FitPlot> plots;
    for (const std::string what : {"storage", "loss", "tan psi"})
      {
        const std::string unit = what == "tan psi" ? " [-]" : " [MPa]";
        plot.name              = what == "tan psi" ? "tan-psi" : what;
        plot.title   = what == "tan psi" ? "Loss factor" : what + " modulus";
        plot.y_label = what + unit;
        plot.y       = {{what + " data" + unit, what + " model" + unit}};
        plots.push_back(plot);
      }
    return plots;
  }



  void DmaFitTask::write_materials(const std::string &folder,
                                   const Data        &data,
                                   const PronyResult &result) const
  {
    const auto head = [&](ParameterInclude include, const std::string &line) {
      include.comments = source_comments(data.files);
      if (!line.empty())
        include.comments.push_back(line);
      include.comments.push_back(result.report.identifiability());
      return include;
    };
    const std::string  file = folder + "/material.prm";
    const unsigned int n    = data.f90.size();
    if (n == 1)
      return head(choice.material(result.series[0]), "").write(file);

    for (unsigned int c = 0; c < n; ++c)
      head(choice.material(result.series[c]),
           "The state of cure " + level_name(data.f90[c]) + " alone.")
        .write(folder + "/material-f90-" + prm_number(data.f90[c]) + ".prm");
    if (n == 2)
      return head(choice.material(result.series[1]),
                  "The state of cure " + level_name(data.f90[1]) +
                    " alone: two levels make no table.")
        .write(file);

    // A table needs four levels; cured rubber does not become stiffer by more
    // of the same (theory A.4).
    auto f90    = data.f90;
    auto series = result.series;
    if (n == 3)
      {
        f90.push_back(1.5 * f90.back());
        series.push_back(series.back());
      }
    head(choice.tables(f90, series, data.f90.back()),
         n == 3 ? "The moduli are held beyond the last level measured." : "")
      .write(file);
  }



  RunStatus DmaFitTask::run(const RunContext &context) const
  {
    const Data         data    = read();
    const auto         outcome = choice.fit(data.curves, data.equilibrium);
    const PronyResult &best    = outcome.best;
    const auto         names   = level_names(data.f90);
    const std::string &folder  = context.output_folder;

    const auto plots = write_fit(folder, data, best.series);
    write_series(folder, names, best.series);
    write_trials(folder, outcome.trials);
    best.report.write_correlations(folder + "/correlations.csv");
    write_materials(folder, data, best);

    Summary summary = summary_of_fit();
    add_to_summary(choice, outcome, names, summary);
    finish_fit(context, summary, plots, "material.prm");
    return RunStatus::completed;
  }
} // namespace demold

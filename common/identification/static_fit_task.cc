// SPDX-License-Identifier: LGPL-2.1-or-later
// The task `static fit`: entries, data files, tables and pictures.
#include "identification/static_fit_task.h"

#include "base/parameter_error.h"
#include "identification/fit_output.h"
#include "identification/parameter_include.h"
#include "output/result_table.h"
#include "output/summary.h"

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr TestMode modes[] = {TestMode::uniaxial,
                                  TestMode::equibiaxial,
                                  TestMode::pure_shear,
                                  TestMode::simple_shear};

    std::vector<DataColumn> columns_of(const TestMode mode)
    {
      if (mode == TestMode::simple_shear)
        return {{"shear [-]", DataColumn::any},
                {"shear stress [MPa]", DataColumn::any}};
      return {{"stretch [-]", DataColumn::positive},
              {"nominal stress [MPa]", DataColumn::any}};
    }



    /// A rubber pulls back: stress and strain have the same sign.
    void check_signs(const TestMode mode, const DataFile &data)
    {
      const double rest = mode == TestMode::simple_shear ? 0. : 1.;
      for (unsigned int i = 0; i < data.n_rows(); ++i)
        if ((data.columns[0][i] - rest) * data.columns[1][i] < 0.)
          throw ExcDataFile(data.file,
                            data.lines[i],
                            "stress and deformation have opposite signs, a "
                            "negative modulus: \"" +
                              columns_of(mode)[0].name + "\" is " +
                              prm_number(data.columns[0][i]) + ", \"" +
                              columns_of(mode)[1].name + "\" is " +
                              prm_number(data.columns[1][i]) + ".");
    }



    void write_fit(const std::string            &file,
                   const StaticFit              &fit,
                   const std::vector<TestCurve> &curves,
                   const double                  mu1,
                   const double                  mu2)
    {
      ResultTable table(file,
                        {"mode",
                         "stretch or shear [-]",
                         "data [MPa]",
                         "model [MPa]",
                         "residual [MPa]",
                         "weight [-]"});
      for (const auto &curve : curves)
        for (unsigned int i = 0; i < curve.x.size(); ++i)
          {
            const auto   by    = stress_by_moduli(curve.mode, curve.x[i]);
            const double model = mu1 * by[0] + mu2 * by[1];
            const bool   used  = fit.uses(curve.mode, curve.x[i]);
            table.add_row({in_words(curve.mode),
                           curve.x[i],
                           curve.stress[i],
                           model,
                           model - curve.stress[i],
                           used ? fit.weight(curve.stress[i]) : 0.});
          }
    }



    /// How the moduli depend on the largest stretch that is used: constants of
    /// the rubber would not.
    void write_range(const std::string            &file,
                     StaticFit                     fit,
                     const std::vector<TestCurve> &curves)
    {
      std::set<double> stretches;
      for (const auto &curve : curves)
        for (const double x : curve.x)
          stretches.insert(largest_stretch(curve.mode, x));
      ResultTable table(file,
                        {"largest stretch [-]",
                         "mu1 [MPa]",
                         "standard error of mu1 [MPa]",
                         "mu2 [MPa]",
                         "standard error of mu2 [MPa]",
                         "rms"});
      for (const double stretch : stretches)
        {
          fit.max_stretch = stretch;
          std::size_t n   = 0;
          for (const auto &curve : curves)
            n += std::count_if(curve.x.begin(),
                               curve.x.end(),
                               [&](const double x) {
                                 return fit.uses(curve.mode, x);
                               });
          if (n < 4)
            continue;
          const FitReport report = fit.fit(curves);
          table.add_row({stretch,
                         report.parameters[0].value,
                         report.parameters[0].standard_error,
                         report.parameters[1].value,
                         report.parameters[1].standard_error,
                         report.rms});
        }
    }
  } // namespace



  void StaticFitTask::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Static fit");
    for (const TestMode mode : modes)
      {
        const auto  columns = columns_of(mode);
        std::string text    = "CSV with the columns ";
        prm.add_parameter(in_words(mode) + " file",
                          files[static_cast<int>(mode)],
                          text + "\"" + columns[0].name + "\" and \"" +
                            columns[1].name + "\"; empty: no such test");
      }
    prm.add_parameter("weights",
                      weights,
                      "absolute: all stresses count alike; relative: by "
                      "their size [-]",
                      Patterns::Selection("absolute|relative"));
    prm.add_parameter("floor",
                      floor,
                      "stress below which relative weights grow no more [MPa]",
                      Patterns::Double(1e-12));
    prm.add_parameter("largest stretch",
                      max_stretch,
                      "data beyond this principal stretch are left out [-]",
                      Patterns::Double(1.));
    prm.add_parameter("lambda",
                      lambda,
                      "Lambda volumetric stiffness, not fitted, handed on to "
                      "material.prm [MPa]",
                      Patterns::Double(0.));
    prm.leave_subsection();
  }



  StaticFit StaticFitTask::fit() const
  {
    StaticFit fit;
    fit.relative    = weights == "relative";
    fit.floor       = floor;
    fit.max_stretch = max_stretch;
    return fit;
  }



  StaticFitTask::Tests StaticFitTask::read() const
  {
    Tests        tests;
    unsigned int n_used = 0;
    for (const TestMode mode : modes)
      {
        const std::string &file = files[static_cast<int>(mode)];
        if (file.empty())
          continue;
        const DataFile data = read_data_file(file, columns_of(mode));
        check_signs(mode, data);
        for (const double x : data.columns[0])
          n_used += fit().uses(mode, x) ? 1 : 0;
        tests.curves.push_back({mode, data.columns[0], data.columns[1]});
        tests.files.push_back(data);
      }
    if (tests.files.empty())
      throw ExcParameter("Static fit/uniaxial file",
                         "at least one test is needed; got none. Name its "
                         "data file here or in one of the entries below.");
    if (n_used < 3)
      throw ExcParameter("Static fit/largest stretch",
                         "must leave at least 3 data; " +
                           prm_number(max_stretch) + " leaves " +
                           std::to_string(n_used) + ". Raise it.");
    return tests;
  }



  void StaticFitTask::check() const
  {
    read();
  }



  std::string StaticFitTask::preview() const
  {
    const Tests        tests = read();
    std::ostringstream text;
    text << "Fits mu1 and mu2 of Mooney and Rivlin, " << weights
         << " weights, up to the stretch " << max_stretch << ":";
    for (unsigned int i = 0; i < tests.curves.size(); ++i)
      text << "\n  " << in_words(tests.curves[i].mode) << ", "
           << tests.files[i].n_rows() << " rows of "
           << std::filesystem::path(tests.files[i].file).filename().string();
    return text.str();
  }



  RunStatus StaticFitTask::run(const RunContext &context) const
  {
    const auto      tests              = read();
    const FitReport report             = fit().fit(tests.curves);
    const double    mu1                = report.parameters[0].value,
                 mu2                   = report.parameters[1].value;
    const std::filesystem::path folder = context.output_folder;
    write_fit((folder / "fit.csv").string(), fit(), tests.curves, mu1, mu2);
    write_range((folder / "range.csv").string(), fit(), tests.curves);
    report.write_correlations((folder / "correlations.csv").string());

    ParameterInclude include;
    include.comments         = source_comments(tests.files);
    const std::string advice = advice_on_modes(tests.curves, report);
    include.comments.push_back(report.identifiability());
    if (!advice.empty())
      include.comments.push_back(advice);
    include.set("model", std::string("mooney-rivlin"));
    include.set("lambda", lambda);
    include.set("mu1", mu1);
    include.set("mu2", mu2);
    include.write((folder / "material.prm").string());

    Summary summary;
    summary.set("status", "completed");
    summary.set("reason", "the data are fitted");
    report.write(fit().relative ? "-" : "MPa", summary);
    summary.set("identifiability",
                advice.empty() ? report.identifiability() :
                                 advice + " " + report.identifiability());
    summary.set("shear modulus [MPa]", mu1 + mu2);

    FitPlot plot;
    plot.name    = "stress";
    plot.title   = "Nominal stress";
    plot.x       = "stretch or shear [-]";
    plot.y_label = "stress [MPa]";
    plot.group   = "mode";
    for (const auto &curve : tests.curves)
      plot.group_values.push_back(in_words(curve.mode));
    plot.y = {{"data [MPa]", "model [MPa]"}};
    finish_fit(context, summary, {plot}, "material.prm");
    return RunStatus::completed;
  }
} // namespace demold

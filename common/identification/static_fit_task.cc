// SPDX-License-Identifier: LGPL-2.1-or-later
// The task `static fit`: entries, data files, what is written.
#include "identification/static_fit_task.h"

#include "base/parameter_error.h"
#include "identification/fit_output.h"
#include "identification/static_fit_output.h"
#include "material/elastic_laws.h"
#include "output/summary.h"

#include <deal.II/base/parameter_handler.h>

#include <filesystem>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr RigMode modes[] = {RigMode::uniaxial,
                                 RigMode::equibiaxial,
                                 RigMode::pure_shear,
                                 RigMode::simple_shear};

    constexpr const char *include_file = "material.prm";

    std::vector<DataColumn> columns_of(const RigMode mode)
    {
      if (mode == RigMode::simple_shear)
        return {{"shear [-]", DataColumn::any},
                {"shear stress [MPa]", DataColumn::any}};
      return {{"stretch [-]", DataColumn::positive},
              {"nominal stress [MPa]", DataColumn::any}};
    }



    /// A rubber pulls back: stress and strain have the same sign.
    void check_signs(const RigMode mode, const DataFile &data)
    {
      const double rest = mode == RigMode::simple_shear ? 0. : 1.;
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
  } // namespace



  void StaticFitTask::add_parameters(ParameterHandler &prm)
  {
    law_name = incompressible_mooney_rivlin().name;
    prm.enter_subsection("Static fit");
    prm.add_parameter("law",
                      law_name,
                      "what is fitted: mooney-rivlin is the law of scenes, of "
                      "the lambda below; ogden is for comparison, no scene has "
                      "it [-]",
                      Patterns::Selection(law_name + "|" + MooneyRivlin::name +
                                          "|" + ogden(1).name));
    prm.add_parameter("ogden terms",
                      n_terms,
                      "number of terms of ogden [-]",
                      Patterns::Integer(1, 2));
    for (const RigMode mode : modes)
      {
        const auto  columns = columns_of(mode);
        std::string text    = "CSV with the columns ";
        prm.add_parameter(name_of(mode) + " file",
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
                      "Lambda volumetric stiffness of mooney-rivlin and of "
                      "material.prm, not fitted [MPa]",
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



  StaticLaw StaticFitTask::law() const
  {
    if (law_name == MooneyRivlin::name)
      return compressible_mooney_rivlin(lambda);
    if (law_name == ogden(n_terms).name)
      return ogden(n_terms);
    return incompressible_mooney_rivlin();
  }



  StaticFitTask::Tests StaticFitTask::read() const
  {
    if (law_name == MooneyRivlin::name && !(lambda > 0.))
      throw ExcParameter("Static fit/lambda",
                         "must be greater than 0 for law = mooney-rivlin; got "
                         "0 MPa. Take 50 to 100 times the shear modulus.");
    Tests tests;
    for (const RigMode mode : modes)
      {
        const std::string &file = files[static_cast<int>(mode)];
        if (file.empty())
          continue;
        tests.files.push_back(read_data_file(file, columns_of(mode)));
        const DataFile &data = tests.files.back();
        check_signs(mode, data);
        tests.curves.push_back({mode, data.columns[0], data.columns[1]});
      }
    if (tests.files.empty())
      throw ExcParameter("Static fit/uniaxial file",
                         "at least one test is needed; got none. Name its "
                         "data file here or in one of the entries below.");
    const unsigned int n        = fit().n_used(tests.curves),
                       n_needed = law().parameters.size() + 1;
    if (n < n_needed)
      throw ExcParameter("Static fit/largest stretch",
                         "must leave at least " + std::to_string(n_needed) +
                           " data; " + prm_number(max_stretch) + " leaves " +
                           std::to_string(n) + ". Raise it.");
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
    text << "Fits " << law_name << ", " << weights
         << " weights, up to the stretch " << max_stretch << ":";
    for (unsigned int i = 0; i < tests.files.size(); ++i)
      text << "\n  " << name_of(tests.curves[i].mode) << ", "
           << extent(tests.files[i], "rows");
    if (!law().for_scenes)
      text << "\nNo scene has this law: " << include_file
           << " will not be written.";
    return text.str();
  }



  std::string StaticFitTask::advice(const Tests           &tests,
                                    const StaticFitResult &result) const
  {
    const std::string modes =
      law().for_scenes ? advice_on_modes(tests.curves, result.report) : "";
    return (modes.empty() ? "" : modes + " ") + result.report.identifiability();
  }



  RunStatus StaticFitTask::run(const RunContext &context) const
  {
    const auto                  tests  = read();
    const StaticLaw             law    = this->law();
    const auto                  result = fit().fit(law, tests.curves);
    const auto                  q      = result.values();
    const std::filesystem::path folder = context.output_folder;
    write_fit(context.output_folder, fit(), law, q, tests.curves);
    write_range(context.output_folder, fit(), law, tests.curves);
    result.report.write_correlations((folder / "correlations.csv").string());

    // That of an earlier fit would be taken for one of this.
    std::filesystem::remove(folder / include_file);
    if (law.for_scenes)
      {
        ParameterInclude include = static_material(lambda, q[0], q[1]);
        include.comments         = source_comments(tests.files);
        include.comments.push_back(advice(tests, result));
        include.write((folder / include_file).string());
      }

    Summary summary = summary_of_fit();
    summary.set("law", law.name);
    result.report.write(fit().relative ? "-" : "MPa", summary);
    summary.set("R2 [-]", result.determination);
    summary.set("remaining slope [-]", result.slope);
    summary.set("identifiability", advice(tests, result));
    double shear_modulus = 0.;
    for (const auto &p : result.report.parameters)
      shear_modulus += p.unit == "MPa" ? p.value : 0.;
    summary.set("shear modulus [MPa]", shear_modulus);
    summary.set("include file",
                law.for_scenes ? include_file : "none: no scene has this law");

    FitPlot plot;
    plot.name    = "stress";
    plot.title   = "Nominal stress, " + law.name;
    plot.x       = "stretch or shear [-]";
    plot.y_label = "stress [MPa]";
    plot.group   = "mode";
    for (const auto &curve : tests.curves)
      plot.group_values.push_back(name_of(curve.mode));
    plot.y = {{"data [MPa]", "model [MPa]"}};
    finish_fit(context, summary, {plot}, law.for_scenes ? include_file : "");
    return RunStatus::completed;
  }
} // namespace demold

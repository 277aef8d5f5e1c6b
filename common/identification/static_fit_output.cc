// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables and include file of a static fit.
#include "identification/static_fit_output.h"

#include "material/elastic_laws.h"
#include "output/result_table.h"

#include <set>

namespace demold
{
  void write_fit(const std::string            &folder,
                 const StaticFit              &fit,
                 const StaticLaw              &law,
                 const std::vector<double>    &parameters,
                 const std::vector<TestCurve> &curves)
  {
    ResultTable table(folder + "/fit.csv",
                      {"mode",
                       "stretch or shear [-]",
                       "data [MPa]",
                       "model [MPa]",
                       "residual [MPa]",
                       "weight [-]"});
    for (const auto &curve : curves)
      for (unsigned int i = 0; i < curve.x.size(); ++i)
        {
          const double model = law.stress(curve.mode, curve.x[i], parameters);
          const bool   used  = fit.uses(curve.mode, curve.x[i]);
          table.add_row({name_of(curve.mode),
                         curve.x[i],
                         curve.stress[i],
                         model,
                         model - curve.stress[i],
                         used ? fit.weight(curve.stress[i]) : 0.});
        }
  }



  void write_range(const std::string            &folder,
                   StaticFit                     fit,
                   const StaticLaw              &law,
                   const std::vector<TestCurve> &curves)
  {
    std::set<double> stretches;
    for (const auto &curve : curves)
      for (const double x : curve.x)
        stretches.insert(largest_stretch(curve.mode, x));
    std::vector<std::string> columns{"largest stretch [-]"};
    for (const auto &p : law.parameters)
      {
        const std::string unit = " [" + p.unit + "]";
        columns.push_back(p.name + unit);
        columns.push_back("standard error of " + p.name + unit);
      }
    columns.insert(columns.end(), {"rms", "R2 [-]"});
    ResultTable table(folder + "/range.csv", columns);
    for (const double stretch : stretches)
      {
        fit.max_stretch = stretch;
        if (fit.n_used(curves) < law.parameters.size() + 2)
          continue;
        const auto                      result = fit.fit(law, curves);
        std::vector<ResultTable::Value> row{stretch};
        for (const auto &p : result.report.parameters)
          row.insert(row.end(), {p.value, p.standard_error});
        row.insert(row.end(), {result.report.rms, result.determination});
        table.add_row(row);
      }
  }



  ParameterInclude static_material(const double lambda,
                                   const double mu1,
                                   const double mu2)
  {
    ParameterInclude include;
    include.set("model", std::string(MooneyRivlin::name));
    include.set("lambda", lambda);
    include.set("mu1", mu1);
    include.set("mu2", mu2);
    return include;
  }
} // namespace demold

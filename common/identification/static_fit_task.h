// SPDX-License-Identifier: LGPL-2.1-or-later
// The task `static fit`: entries, data files, tables and pictures.
#ifndef demold_identification_static_fit_task_h
#define demold_identification_static_fit_task_h

#include "base/data_file.h"
#include "base/run_step.h"
#include "identification/static_fit.h"

#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Section `Static fit`: mu1 and mu2 from slow tests. Writes fit.csv (data,
  /// model, residual), range.csv (the fit over the largest stretch used),
  /// correlations.csv, material.prm, pictures and summary.json.
  class StaticFitTask
  {
  public:
    void        add_parameters(dealii::ParameterHandler &prm);
    void        check() const;
    std::string preview() const;
    RunStatus   run(const RunContext &context) const;

  private:
    struct Tests
    {
      std::vector<DataFile>  files;
      std::vector<TestCurve> curves;
    };

    StaticFit fit() const;

    /// Reads and checks all files; throws ExcParameter, ExcDataFile.
    Tests read() const;

    std::string files[4]; // in the order of TestMode
    std::string weights     = "absolute";
    double      floor       = 0.01; // [MPa]
    double      max_stretch = 100.; // [-]
    double      lambda      = 50.;  // [MPa]
  };
} // namespace demold

#endif

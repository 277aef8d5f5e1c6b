// SPDX-License-Identifier: LGPL-2.1-or-later
// The task `static fit`: entries, data files, what is written.
#ifndef demold_identification_static_fit_task_h
#define demold_identification_static_fit_task_h

#include "base/data_file.h"
#include "base/run_step.h"
#include "identification/static_fit.h"

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Section `Static fit`: an elastic law from slow tests. Writes fit.csv
  /// (data, model, residual), range.csv (the fit over the largest stretch
  /// used), correlations.csv, material.prm if scenes know the law, a picture
  /// and summary.json.
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
    StaticLaw law() const;

    /// What the include file says of mu1 and mu2, or why there is none.
    std::string advice(const Tests &tests, const StaticFitResult &result) const;

    /// Reads and checks all files; throws ExcParameter, ExcDataFile.
    Tests read() const;

    std::string  files[4]; // uniaxial, equibiaxial, pure and simple shear
    std::string  law_name;
    unsigned int n_terms     = 2;
    std::string  weights     = "absolute";
    double       floor       = 0.01; // [MPa]
    double       max_stretch = 100.; // [-]
    double       lambda      = 50.;  // [MPa]
  };
} // namespace demold

#endif

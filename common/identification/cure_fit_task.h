// SPDX-License-Identifier: LGPL-2.1-or-later
// The task `cure fit`: entries, rheometer curves, predictions.
#ifndef demold_identification_cure_fit_task_h
#define demold_identification_cure_fit_task_h

#include "base/data_file.h"
#include "base/run_step.h"
#include "identification/cure_fit.h"

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  class Summary;

  /// Section `Cure fit`: t90 over temperature and the kinetics. Writes fit.csv
  /// (degree of cure), times.csv (t10, t50, t90 of each curve),
  /// correlations.csv, cure.prm (section Cure), a picture and summary.json.
  class CureFitTask
  {
  public:
    void        add_parameters(dealii::ParameterHandler &prm);
    void        check() const;
    std::string preview() const;
    RunStatus   run(const RunContext &context) const;

  private:
    /// One of the subsections `Curve 1` ...
    struct Entry
    {
      std::string file;
      double      temperature = 160.; // [degC]
    };

    struct Data
    {
      std::vector<DataFile>       files;
      std::vector<RheometerCurve> curves;
    };

    Data read() const;

    void add_times(const std::vector<RheometerCurve> &curves,
                   Summary                           &summary) const;
    void add_predictions(const CureFit                     &fit,
                         const CureFitResult               &result,
                         const std::vector<RheometerCurve> &curves,
                         Summary                           &summary) const;

    std::array<Entry, 6> entries;
    std::string          law                   = KamalSourour::name;
    double               reference_temperature = 160.; // [degC]
    std::vector<double>  predicted;                    // [degC]
  };
} // namespace demold

#endif

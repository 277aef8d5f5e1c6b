// SPDX-License-Identifier: LGPL-2.1-or-later
// The task `relaxation fit`: Prony series from a curve in time.
#ifndef demold_identification_relaxation_fit_task_h
#define demold_identification_relaxation_fit_task_h

#include "base/data_file.h"
#include "base/run_step.h"
#include "identification/prony_choice.h"

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Section `Relaxation fit`: stress over held strain, small strain. Writes
  /// fit.csv, series.csv, branches.csv, correlations.csv, material.prm, a
  /// picture and summary.json.
  class RelaxationFitTask
  {
  public:
    void        add_parameters(dealii::ParameterHandler &prm);
    void        check() const;
    std::string preview() const;
    RunStatus   run(const RunContext &context) const;

  private:
    struct Data
    {
      DataFile   file;
      PronyCurve curve;
    };

    Data read() const;

    std::string file;
    double      ramp        = 0.; // [s]
    double      equilibrium = 0.; // E_inf [MPa]; 0: fitted
    PronyChoice choice;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// The task `dma fit`: Prony series from storage and loss moduli.
#ifndef demold_identification_dma_fit_task_h
#define demold_identification_dma_fit_task_h

#include "base/data_file.h"
#include "base/run_step.h"
#include "identification/fit_output.h"
#include "identification/prony_choice.h"

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Section `Dma fit`: E' and E'' over frequency of one state of cure, or of
  /// several with relaxation times in common. Writes fit.csv, series.csv (tau_j
  /// and E_j), branches.csv (the criterion), correlations.csv, material.prm,
  /// material-f90-*.prm, pictures and summary.json.
  class DmaFitTask
  {
  public:
    void        add_parameters(dealii::ParameterHandler &prm);
    void        check() const;
    std::string preview() const;
    RunStatus   run(const RunContext &context) const;

  private:
    /// One of the subsections `Level 1` ...
    struct Level
    {
      std::string file;
      double      f90         = 1.; // [-]
      double      equilibrium = 0.; // E_inf [MPa]; 0: fitted
    };

    struct Data
    {
      std::vector<DataFile>   files;
      std::vector<double>     f90;
      std::vector<double>     equilibrium; // as in PronyFit
      std::vector<PronyCurve> curves;
    };

    Data read() const;

    std::vector<FitPlot>
    write_fit(const std::string              &folder,
              const Data                     &data,
              const std::vector<PronySeries> &series) const;

    void write_materials(const std::string &folder,
                         const Data        &data,
                         const PronyResult &result) const;

    std::array<Level, 6> levels;
    PronyChoice          choice;
  };
} // namespace demold

#endif

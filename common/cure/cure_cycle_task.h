// SPDX-License-Identifier: LGPL-2.1-or-later
// A press cycle over the thickness of a block: temperature and cure.
#ifndef demold_cure_cure_cycle_task_h
#define demold_cure_cure_cycle_task_h

#include "base/run_step.h"
#include "cure/cure_parameters.h"
#include "cure/press_parameters.h"

#include <string>
#include <vector>

namespace demold
{
  /// Sections Cure, Press and Cure cycle. Heat conduction through the
  /// thickness, then the cure of every depth over its temperature (one-way: the
  /// heat of the reaction is neglected). Writes
  /// * history.csv: temperature, f90, degree of cure at the depths asked for,
  /// * profile.csv: the same over the depth, at the opening and at the end,
  /// * summary.json and pictures of both tables.
  class CureCycleTask
  {
  public:
    void        add_parameters(dealii::ParameterHandler &prm);
    void        check() const;
    std::string preview() const;
    RunStatus   run(const RunContext &context) const;

  private:
    CureParameters  cure;
    PressParameters press;

    double              thickness       = 8.;
    unsigned int        n_elements      = 40;
    std::vector<double> depths          = {0., 4., 8.};
    double              output_interval = 5.;
  };
} // namespace demold

#endif

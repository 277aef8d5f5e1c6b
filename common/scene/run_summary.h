// SPDX-License-Identifier: LGPL-2.1-or-later
// summary.json of a run: how it ended, what it found, what it cost.
#ifndef demold_scene_run_summary_h
#define demold_scene_run_summary_h

#include "base/run_step.h"
#include "output/summary.h"
#include "solution/linear_solver_parameters.h"
#include "solution/strategy.h"

#include <mpi.h>

#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  class Timer;
}

namespace demold
{
  class InterfaceTerm;
  class Recorder;
  class WeakForm;
  struct VulcanisedRange;

  /// What a run knows about itself when it ends.
  struct RunAccount
  {
    StrategyResult         result; ///< with what was before a restart
    bool                   was_stopped = false; ///< by a signal
    unsigned int           increments  = 0;     ///< with those before a restart
    LinearSolverStatistics linear; ///< counts likewise, seconds since then
    double                 seconds_assembly = 0.; ///< contact included
    double                 seconds_output   = 0.;
    const Recorder        &recorder;
    const WeakForm        &weak_form;
    const InterfaceTerm   *interface; ///< may be null
    const VulcanisedRange *cure;      ///< null: not computed
    const dealii::Timer   &timer;     ///< of the whole run

    RunStatus status() const;

    /// Where the time went [s], in the order of the summary.
    std::vector<std::pair<std::string, double>> times() const;
  };

  /// The summary of a run; collective.
  Summary summarise(const RunAccount &account, MPI_Comm communicator);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
//
// # step-material: what does curing rubber answer, and how do we know?
//
// Sample runs:
//   step-material prm/step-material/relaxation.prm
//   step-material prm/step-material/wiechert.prm --set "Protocol/mean
//   strain=0.3" step-material prm/step-material/treloar-fit.prm
//
//   measured curves                     constants                 answers
//   tension, shear     -> static fit     -> mu1, mu2      \
//   E', E'' over freq. -> dma fit        -> E_j, tau_j     \  material.prm
//   relaxation         -> relaxation fit -> E_j, tau_j      > -> protocol
//   rheometer torque   -> cure fit       -> E_a, k, n      /  -> step-demold
//   press temperatures -> cure cycle     -> f90 over depth/
//   cords and rubber   -> ply            -> E1, E2, G12 of a belt
//
// The lesson of thesis chapter 4. Nothing here has a mesh, and each task takes
// seconds; intro.md has the equations, results.md what comes out.

#include "base/run_step.h"
#include "cure/cure_cycle_task.h"
#include "identification/cure_fit_task.h"
#include "identification/dma_fit_task.h"
#include "identification/relaxation_fit_task.h"
#include "identification/static_fit_task.h"
#include "rig/ply_task.h"
#include "rig/protocol_task.h"

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

using namespace demold;
using dealii::ParameterHandler;

namespace
{
  // ## The program
  //
  // Each task is a front of its own, with sections of its own in the parameter
  // file; the entry `task` says whose turn it is. The others' sections stay at
  // their defaults and are not checked.
  class StepMaterial
  {
  public:
    void add_parameters(ParameterHandler &prm)
    {
      std::string names;
      for (const auto &[name, front] : tasks)
        names += (names.empty() ? "" : "|") + name;
      prm.add_parameter("task",
                        task,
                        "what is done, by the section of the same name [-]",
                        dealii::Patterns::Selection(names));
      for (const auto &[name, front] : tasks)
        front.add_parameters(prm);
    }

    void check() const
    {
      chosen().check();
    }

    std::string preview() const
    {
      return "What will be simulated\n  task        " + task + "\n" +
             chosen().preview();
    }

    RunStatus run(const RunContext &context) const
    {
      return chosen().run(context);
    }

  private:
    const StepFront &chosen() const
    {
      for (const auto &[name, front] : tasks)
        if (name == task)
          return front;
      return tasks.front().second; // the pattern of the entry lets none by
    }

    std::string task = "protocol";

    const std::vector<std::pair<std::string, StepFront>> tasks = {
      {"protocol", make_front<ProtocolTask>()},
      {"static fit", make_front<StaticFitTask>()},
      {"dma fit", make_front<DmaFitTask>()},
      {"relaxation fit", make_front<RelaxationFitTask>()},
      {"cure fit", make_front<CureFitTask>()},
      {"cure cycle", make_front<CureCycleTask>()},
      {"ply", make_front<PlyTask>()}};
  };
} // namespace

int main(int argc, char **argv)
{
  return run_step<StepMaterial>(argc, argv);
}

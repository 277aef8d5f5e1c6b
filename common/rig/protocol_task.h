// SPDX-License-Identifier: LGPL-2.1-or-later
// The task `protocol`: rubber driven through a test, without a mesh.
#ifndef demold_rig_protocol_task_h
#define demold_rig_protocol_task_h

#include "base/run_step.h"
#include "rig/protocol_parameters.h"

#include <string>

namespace demold
{
  /// Writes history.csv (the curves), cases.csv (a row per run), pictures and
  /// summary.json.
  class ProtocolTask
  {
  public:
    void        add_parameters(dealii::ParameterHandler &prm);
    void        check() const;
    std::string preview() const;
    RunStatus   run(const RunContext &context) const;

  private:
    ProtocolParameters parameters;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables and pictures of the runs of a protocol.
#ifndef demold_rig_protocol_output_h
#define demold_rig_protocol_output_h

#include "output/summary.h"
#include "rig/protocol_run.h"

#include <string>
#include <vector>

namespace demold
{
  /// Name of the column of what is swept; empty if nothing is.
  std::string swept_column(const ProtocolParameters &parameters);

  /// Name of the column of the reference.
  std::string reference_column(const ProtocolParameters &parameters);

  /// history.csv: a row per step and run, `case [-]` counting the runs from 1;
  /// of a frequency sweep the last cycles only.
  void write_curves(const std::string              &file,
                    const ProtocolParameters       &parameters,
                    const std::vector<ProtocolRun> &runs);

  /// cases.csv: a row per run with all its quantities.
  void write_cases(const std::string              &file,
                   const ProtocolParameters       &parameters,
                   const std::vector<ProtocolRun> &runs);

  /// The quantities of the last run; but the largest of every error and the
  /// sums of steps, iterations and CPU time over all runs.
  Summary protocol_summary(const std::vector<ProtocolRun> &runs);

  /// Draws; returns what went wrong, as draw_scripts().
  std::string draw_protocol(const std::string              &output_folder,
                            const ProtocolParameters       &parameters,
                            const std::vector<ProtocolRun> &runs);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// One run of the rig and the numbers it is asked for.
#ifndef demold_rig_protocol_run_h
#define demold_rig_protocol_run_h

#include "rig/protocol_parameters.h"
#include "rig/relaxation_reference.h"
#include "rig/rig_curve.h"

#include <string>
#include <utility>
#include <vector>

namespace demold
{
  /// A run with its reference, if there is one, and its quantities, named with
  /// their units as summary.json has them.
  struct ProtocolRun
  {
    ProtocolCase                                test;
    RigCurve                                    curve;
    RelaxationReference                         reference;
    std::vector<std::pair<std::string, double>> quantities;

    bool has_reference() const
    {
      return !reference.nominal.empty();
    }
  };

  /// Drives the law of @p test; `cpu time [s]` is that of one pass without the
  /// reference, the mean of as many as take a twentieth of a second.
  ProtocolRun run_protocol(const ProtocolParameters &parameters,
                           const ProtocolCase       &test);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// The curve of a programme by an error-controlled integrator.
#ifndef demold_rig_relaxation_reference_h
#define demold_rig_relaxation_reference_h

#include "rig/loading.h"
#include "rig/rig_curve.h"
#include "rig/rig_mode.h"

#include <vector>

namespace demold
{
  /// What SUNDIALS IDA finds for a law in a programme: the relaxation equations
  /// of FlowRule together with the equilibrium of what the grips leave free, as
  /// differential-algebraic equations. Shares with RubberLaw the elastic law
  /// alone, nothing of its time stepping.
  struct RelaxationReference
  {
    std::vector<double> nominal; ///< [MPa], for each row of the curve
    std::vector<double> strain;  ///< [-]
    long                n_steps = 0;
  };

  /// The reference at the times of @p curve, which run_rig() has given, with
  /// the error of a step below @p tolerance relative to the stretches.
  RelaxationReference relaxation_reference(const RubberLaw &law,
                                           RigMode          mode,
                                           const Loading   &loading,
                                           const RigCurve  &curve,
                                           double           tolerance = 1e-10);
} // namespace demold

#endif

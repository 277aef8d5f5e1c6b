// SPDX-License-Identifier: LGPL-2.1-or-later
// Small vibrations: what the rig measures, and what Wiechert's model says.
#ifndef demold_rig_linear_limit_h
#define demold_rig_linear_limit_h

#include "material/rubber_law.h"
#include "rig/rig_curve.h"

#include <complex>

namespace demold
{
  /// E' + i E'' [MPa] of the first harmonic at @p frequency [Hz] in the last
  /// full cycle of @p curve, whose strain is a sine of @p amplitude [-] that
  /// begins at time 0: least squares on the first two harmonics (the second is
  /// there because rubber is softer in tension than in compression) and a
  /// parabola in time, which takes up the mean and the end of the transient.
  std::complex<double> measured_modulus(const RigCurve &curve,
                                        double          frequency,
                                        double          amplitude);

  /// The same of Wiechert's model (theory A.2, E.9) in the mode: Lame constants
  /// of the relaxed law and of the branches at omega = 2 pi @p frequency, at
  /// the finite bulk modulus of the law (correspondence principle).
  std::complex<double> wiechert_modulus(const RubberLaw &law,
                                        RigMode          mode,
                                        double           frequency);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// A rubber law driven through a programme: the curve and its energies.
#ifndef demold_rig_rig_curve_h
#define demold_rig_rig_curve_h

#include "rig/loading.h"
#include "rig/rig_point.h"

#include <vector>

namespace demold
{
  /// A row of the curve. Energies are sums since time 0, but for `stored`.
  struct RigRow
  {
    double   time = 0.; ///< [s]
    RigState state;
    double   work       = 0.; ///< of the grips [mJ/mm^3]
    double   dissipated = 0.; ///< in the dashpots [mJ/mm^3]
  };

  struct RigCurve
  {
    /// The rested rubber first; after a jump a second row of time 0.
    std::vector<RigRow> rows;

    double       largest_nominal() const;  ///< [MPa]
    double       smallest_nominal() const; ///< [MPa]
    unsigned int n_iterations() const;     ///< of Newton's method

    /// Work of the grips between two times [mJ/mm^3]: around a cycle, its
    /// hysteresis.
    double work_between(double start, double end) const;

    /// max |work - stored - dissipated| over the largest of the three.
    double energy_balance_error() const;
  };

  /// Work by the trapezoidal rule over the steps: second order. A jump is
  /// elastic, its work that along a straight path, to round-off but with
  /// BranchLaw::convolution, whose dissipation is work by the trapezoidal rule.
  RigCurve run_rig(const RubberLaw &law, RigMode mode, const Loading &loading);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Tension limit that falls exponentially with the decohesion gap.
#include "adhesion/exponential_softening.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  double ExponentialSoftening::onset_gap() const
  {
    return strength / penalty;
  }



  double ExponentialSoftening::rupture_gap() const
  {
    return -gap * std::log(residual_limit) + residual_limit * onset_gap();
  }



  double ExponentialSoftening::fracture_energy() const
  {
    // Softening work plus the elastic part of the bond at the cut.
    const double limit = residual_limit * strength;
    return (strength - limit) * gap + 0.5 * limit * limit / penalty;
  }



  double ExponentialSoftening::steepest_slope() const
  {
    return strength / (gap - onset_gap());
  }



  double ExponentialSoftening::decohesion_gap(const double kappa) const
  {
    // f(x) = x + q (e^-x - 1) - r rises and is convex, and both starts lie to
    // the right of its root: Newton comes down to the root and never crosses
    // it, so the first step that does not go down is round-off.
    const double q = onset_gap() / gap;
    const double r = (kappa - onset_gap()) / gap;
    if (r <= 0.)
      return 0.;
    double x = std::min(r / (1. - q), r + q);
    for (unsigned int i = 0; i < 100; ++i)
      {
        const double decay = std::expm1(-x);
        const double next  = x - (x + q * decay - r) / (1. - q - q * decay);
        if (!(next < x))
          break;
        x = next;
      }
    return gap * x;
  }



  SofteningPoint ExponentialSoftening::on_curve(const double kappa) const
  {
    const double x     = decohesion_gap(kappa) / gap;
    const double limit = strength * std::exp(-x);
    return {limit,
            -limit / (gap - limit / penalty),
            gap * (-strength * std::expm1(-x) - 0.5 * limit * x)};
  }



  double ExponentialSoftening::secant(const double kappa) const
  {
    return secant_of(*this, kappa);
  }



  double ExponentialSoftening::secant_derivative(const double kappa) const
  {
    return secant_derivative_of(*this, kappa);
  }



  double ExponentialSoftening::dissipated(const double kappa) const
  {
    return dissipated_of(*this, kappa);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Tension limit that falls linearly with the decohesion gap (thesis reading).
#include "adhesion/linear_softening.h"

namespace demold
{
  double LinearSoftening::onset_gap() const
  {
    return strength / penalty;
  }



  double LinearSoftening::rupture_gap() const
  {
    return gap;
  }



  double LinearSoftening::fracture_energy() const
  {
    return 0.5 * strength * gap;
  }



  double LinearSoftening::steepest_slope() const
  {
    return strength / (gap - onset_gap());
  }



  SofteningPoint LinearSoftening::on_curve(const double kappa) const
  {
    const double slope = steepest_slope();
    return {slope * (gap - kappa),
            -slope,
            0.5 * slope * gap * (kappa - onset_gap())};
  }



  double LinearSoftening::secant(const double kappa) const
  {
    return secant_of(*this, kappa);
  }



  double LinearSoftening::secant_derivative(const double kappa) const
  {
    return secant_derivative_of(*this, kappa);
  }



  double LinearSoftening::dissipated(const double kappa) const
  {
    return dissipated_of(*this, kappa);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// How far a Maxwell branch is from equilibrium, and what that costs in a step.
#ifndef demold_material_overstress_h
#define demold_material_overstress_h

#include "material/symmetric_six.h"

namespace demold
{
  /// Overstress of a branch at one time, as the dissipation needs it.
  struct Overstress
  {
    Nine   M;      ///< dev(Cbar C_i^-1) = F^T dev(be_bar) F^-T [-]
    double square; ///< tr M^2 = |dev be_bar|^2 >= 0 [-]
    double energy; ///< 2 W / mu = Cbar : C_i^-1 - 3 >= 0 [-]
    double rate;   ///< 2 tau D / mu >= 0, here `square` too (theory A8) [-]

    /// An isochoric branch: from Cbar C_i^-1, both factors of determinant one.
    explicit Overstress(const Nine &product);

    /// A branch whose C_i is free to change its volume: M is
    /// @p X = C C_i^-1 - 1, the energy 2 W/mu = tr b_e - 3 - ln det b_e
    /// (theory A.2, variant V2), the rate what its flow rule makes of it.
    static Overstress with_volume(const Nine &X, double rate);

  private:
    Overstress() = default;
  };

  /// Dissipated energy over a step, divided by mu [-], from the overstress at
  /// its ends; @p h is the step over the relaxation time.
  ///
  /// The rate D is exact, for an isochoric branch mu/(2 tau) |dev be_bar|^2
  /// (theory A8). With x^2 = 2 W/mu it reads D = mu (phi/tau) x^2,
  /// phi = (2 tau D/mu)/(2 x^2), phi -> 1 at small strain. Where the strain
  /// moves at a constant rate the branch obeys x' = rate - (phi/tau) x; the
  /// integral of x^2 along that solution, between the known x at both ends, is
  /// closed form:
  ///   D/mu = alpha x0^2 + beta x0 x1 cos + gamma x1^2,  H = h (phi0+phi1)/2.
  /// A step much shorter than tau gives H/3 (x0^2 + x0 x1 + x1^2), one much
  /// longer than tau the stored energy lost, x0^2/2, plus steady flow H x1^2.
  /// Never negative, second order, and sensible for any h, where a trapezoid
  /// of D over a relaxing step would be wrong by the factor h.
  double dissipation_over_step(const Overstress &start,
                               const Overstress &end,
                               double            h);
} // namespace demold

#endif

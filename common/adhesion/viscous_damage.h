// SPDX-License-Identifier: LGPL-2.1-or-later
// Damage that takes time: how far it gets in an increment, and what that costs.
#ifndef demold_adhesion_viscous_damage_h
#define demold_adhesion_viscous_damage_h

#include "adhesion/softening.h"

namespace demold
{
  /// Where damage has got to.
  struct DamageReached
  {
    double kappa = 0.; ///< [mm], not cut at rupture
    double rate  = 0.; ///< dkappa/d(effective gap) [-], from 0 to 1
  };

  /// Viscous damage, after Simo and Ju 1987, with the overstress
  /// in units of the limit: kappa' = (delta/tau) <gap/kappa - 1>, gap the
  /// effective one, so that the secant traction is that of a bond with a
  /// dashpot beside it,
  ///
  ///   k(kappa) gap = s(kappa) (1 + tau kappa'/delta),
  ///
  /// the rate law of theory C.5 with n = 1 and v_ref = delta/tau. The excess
  /// does not depend on the penalty, and damage is complete in finite time.
  ///
  /// One step of backward Euler from @p start [mm] to the effective gap
  /// @p effective [mm]: kappa (kappa - start) = reach (gap - kappa), of which
  /// this is the root near start. @p reach = delta dt/tau [mm]; at 0 damage
  /// stands still, at infinity it is where the gap is.
  DamageReached viscous_damage(const double start,
                               const double effective,
                               const double reach);

  /// Integral of ((1 + x)^2 - 1) dD(kappa) [mJ/mm^2]: what a bond loses beyond
  /// D while kappa goes from @p start to @p end [mm], at most to rupture, and
  /// the relative overstress x = gap/kappa - 1 linearly from @p first to
  /// @p last [-]. Never negative. D and dD/dkappa: theory C6.
  double overstress_work(const Softening &softening,
                         const double     start,
                         const double     end,
                         const double     first,
                         const double     last);
} // namespace demold

#endif

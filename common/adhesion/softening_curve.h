// SPDX-License-Identifier: LGPL-2.1-or-later
// What every softening law has in common: from tension limit to secant.
#ifndef demold_adhesion_softening_curve_h
#define demold_adhesion_softening_curve_h

namespace demold
{
  /// One point of the softening branch over the effective gap kappa, continued
  /// beyond rupture (Newton needs it there).
  struct SofteningPoint
  {
    /// s, tension limit at this point [MPa].
    double limit = 0.;
    /// ds/dkappa [MPa/mm], negative.
    double slope = 0.;
    /// D, lost per area up to here when unloading aims at the origin
    /// [mJ/mm^2], theory C6.
    double dissipated = 0.;
  };

  /// k(kappa) [MPa/mm]: penalty up to the onset gap, limit/kappa on the
  /// softening branch, zero from the rupture gap on. Theory C.2.
  template <typename Law>
  double secant_of(const Law &law, const double kappa)
  {
    if (kappa <= law.onset_gap())
      return law.penalty;
    return kappa < law.rupture_gap() ? law.on_curve(kappa).limit / kappa : 0.;
  }

  /// dk/dkappa [MPa/mm^2]; zero off the softening branch.
  template <typename Law>
  double secant_derivative_of(const Law &law, const double kappa)
  {
    if (kappa <= law.onset_gap() || kappa >= law.rupture_gap())
      return 0.;
    const SofteningPoint point = law.on_curve(kappa);
    return (point.slope - point.limit / kappa) / kappa;
  }

  /// D(kappa) [mJ/mm^2]; the whole fracture energy from the rupture gap on.
  template <typename Law>
  double dissipated_of(const Law &law, const double kappa)
  {
    if (kappa <= law.onset_gap())
      return 0.;
    return kappa < law.rupture_gap() ? law.on_curve(kappa).dissipated :
                                       law.fracture_energy();
  }
} // namespace demold

#endif

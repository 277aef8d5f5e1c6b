// SPDX-License-Identifier: LGPL-2.1-or-later
// Tension limit that falls exponentially with the decohesion gap.
#ifndef demold_adhesion_exponential_softening_h
#define demold_adhesion_exponential_softening_h

#include "adhesion/softening_curve.h"

namespace demold
{
  /// s(g_d) = alpha exp(-g_d/delta_e), theory C.6. The bond is cut where
  /// s = residual_limit alpha; what it still stores there is lost at the cut
  /// and counted, so that the dissipation at rupture is fracture_energy():
  /// alpha delta_e but for one part in 1/residual_limit. An infinite penalty
  /// is allowed as in LinearSoftening.
  struct ExponentialSoftening
  {
    static constexpr const char *name = "exponential";
    /// s/alpha at which the bond counts as separated [-].
    static constexpr double residual_limit = 1e-6;

    /// alpha, strength [MPa].
    double strength = 0.1;
    /// delta_e, decohesion gap over which the limit falls by e [mm].
    double gap = 0.2;
    /// gamma, stiffness of the intact bond [MPa/mm], above alpha/delta_e.
    double penalty = 20.;

    /// g_0 = alpha/gamma [mm].
    double onset_gap() const;
    /// Effective gap at the cut [mm]: delta_e ln(1/residual_limit) + s/gamma.
    double rupture_gap() const;
    /// Work up to the cut [mJ/mm^2].
    double fracture_energy() const;
    /// Largest -ds/dkappa [MPa/mm], at the onset.
    double steepest_slope() const;
    /// g_d [mm] from kappa = g_d + s(g_d)/gamma, kappa >= g_0, to round-off.
    double decohesion_gap(const double kappa) const;
    /// The softening branch at any @p kappa >= g_0 [mm], not cut at rupture.
    SofteningPoint on_curve(const double kappa) const;
    /// k(kappa) [MPa/mm].
    double secant(const double kappa) const;
    /// dk/dkappa [MPa/mm^2].
    double secant_derivative(const double kappa) const;
    /// D(kappa) = alpha delta_e (1 - e^-x - x/2 e^-x), x = g_d/delta_e
    /// [mJ/mm^2]: work up to kappa less the s kappa/2 still stored.
    double dissipated(const double kappa) const;
  };
} // namespace demold

#endif

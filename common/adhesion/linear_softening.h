// SPDX-License-Identifier: LGPL-2.1-or-later
// Tension limit that falls linearly with the decohesion gap (thesis reading).
#ifndef demold_adhesion_linear_softening_h
#define demold_adhesion_linear_softening_h

#include "adhesion/softening_curve.h"

namespace demold
{
  /// s(g_d) = alpha (1 - g_d/delta), theory C1; over the whole effective gap
  /// kappa = g_d + s/gamma this is a bilinear law: peak alpha at g_0, zero at
  /// delta (theory C3). An infinite penalty is the rigid onset of the mortar
  /// formulation, theory C.4 (then only kappa > 0 has a secant).
  struct LinearSoftening
  {
    static constexpr const char *name = "linear softening";

    /// alpha, strength [MPa].
    double strength = 0.1;
    /// delta, gap at which nothing holds any more [mm].
    double gap = 0.2;
    /// gamma, stiffness of the intact bond [MPa/mm], above alpha/delta.
    double penalty = 20.;

    /// g_0 = alpha/gamma [mm].
    double onset_gap() const;
    /// delta [mm].
    double rupture_gap() const;
    /// G_c = alpha delta/2 [mJ/mm^2], theory C5.
    double fracture_energy() const;
    /// Largest -ds/dkappa [MPa/mm], theory D1.
    double steepest_slope() const;
    /// The softening branch at any @p kappa [mm], not cut at rupture.
    SofteningPoint on_curve(const double kappa) const;
    /// k(kappa) [MPa/mm].
    double secant(const double kappa) const;
    /// dk/dkappa [MPa/mm^2], theory C7.
    double secant_derivative(const double kappa) const;
    /// D(kappa) = G_c g_d/delta [mJ/mm^2], theory C6.
    double dissipated(const double kappa) const;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// The effective gap at which softening and an augmentation carry a traction.
#ifndef demold_adhesion_radial_gap_h
#define demold_adhesion_radial_gap_h

#include "adhesion/softening.h"

namespace demold
{
  /// Softening law of one point: its tension limit and losses are those of
  /// the law times the strength factor. Theory C.4 needs it rigid.
  struct PointSoftening
  {
    const Softening &softening;
    double           strength_factor; ///< [-]

    /// The curve at any @p kappa [mm], beyond rupture as the law goes on, below
    /// 0 along its tangent there (forced decohesion, theory D.2).
    SofteningPoint at(const double kappa) const;

    /// Has a traction [MPa] of this size a direction to soften along?
    bool feels(const double traction) const;

    /// Work of separation [mJ/mm^2].
    double fracture_energy() const;
  };

  /// Solution of s(q) + c q = r.
  struct RadialGap
  {
    double gap;  ///< q [mm], negative where r is below the strength
    double rate; ///< dq/dr = 1/(c + s'(q)) [mm/MPa]
  };

  /// Unique where @p c [MPa/mm] exceeds the steepest softening (C8); Newton's
  /// method, which comes down to the root since s is convex. @p r [MPa].
  RadialGap radial_gap(const PointSoftening &softening,
                       const double          c,
                       const double          r);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// The effective gap at which softening and an augmentation carry a traction.
#include "adhesion/radial_gap.h"

#include <algorithm>

namespace demold
{
  SofteningPoint PointSoftening::at(const double kappa) const
  {
    SofteningPoint point = std::visit(
      [&](const auto &law) { return law.on_curve(std::max(kappa, 0.)); },
      softening);
    if (kappa < 0.)
      {
        point.dissipated += 0.5 * point.limit * kappa;
        point.limit += point.slope * kappa;
      }
    return {strength_factor * point.limit,
            strength_factor * point.slope,
            strength_factor * point.dissipated};
  }



  bool PointSoftening::feels(const double traction) const
  {
    return traction > 1e-14 * at(0.).limit;
  }



  double PointSoftening::fracture_energy() const
  {
    return strength_factor *
           std::visit([](const auto &law) { return law.fracture_energy(); },
                      softening);
  }



  RadialGap radial_gap(const PointSoftening &softening,
                       const double          c,
                       const double          r)
  {
    // s(q) + c q - r rises and is convex: the first step lands to the right of
    // the root, all later ones go down, and the first that does not is
    // round-off.
    double q = r / c;
    for (unsigned int i = 0; i < 100; ++i)
      {
        const SofteningPoint at   = softening.at(q);
        const double         next = q - (at.limit + c * q - r) / (c + at.slope);
        if (i > 0 && !(next < q))
          break;
        q = next;
      }
    return {q, 1. / (c + softening.at(q).slope)};
  }
} // namespace demold

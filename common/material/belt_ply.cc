// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress, tangent and energy of cords in rubber in closed form.
#include "material/belt_ply.h"

#include <cmath>

namespace demold
{
  void FibreFamily::add(const Deformation &x,
                        const bool         with_tangent,
                        ResponseSums      &sums) const
  {
    const auto &a = direction;
    const Six   M = {{a[0] * a[0],
                      a[1] * a[1],
                      a[2] * a[2],
                      a[0] * a[1],
                      a[0] * a[2],
                      a[1] * a[2]}};

    // lambda - 1 from I4 - 1, without cancellation: k is 10^4 of the rubber's.
    const double stretch = std::sqrt(contract(M, x.C));
    const double excess =
      contract(M, difference(x.C, six_identity)) / (stretch + 1.);
    const double k = excess >= 0. ? stiffness : compression * stiffness;

    sums.stored += .5 * k * excess * excess;
    add_scaled(sums.S, k * excess / stretch, M);
    if (with_tangent)
      sums.add_rest(M, k / (stretch * stretch * stretch), 0.);
  }

  void BeltPly::add(const Deformation &x,
                    const bool         with_tangent,
                    ResponseSums      &sums) const
  {
    matrix.add(x, with_tangent, sums);
    for (const FibreFamily &family : fibres)
      family.add(x, with_tangent, sums);
  }
} // namespace demold

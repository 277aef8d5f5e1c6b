// SPDX-License-Identifier: LGPL-2.1-or-later
// Damage that takes time: how far it gets in an increment, and what that costs.
#include "adhesion/viscous_damage.h"

#include "adhesion/bond_branch.h"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>

namespace demold
{
  DamageReached viscous_damage(const double start,
                               const double effective,
                               const double reach)
  {
    // With y = kappa - start: y^2 + (start + reach) y = reach (gap - start),
    // solved without cancellation. A gap of 0 or more has a real root.
    const double sum    = start + reach;
    const double excess = effective - start;
    const double root   = std::sqrt(sum * sum + 4. * reach * excess);
    if (!(root > 0.))
      return {start, 0.};
    return {start + 2. * reach * excess / (sum + root), reach / root};
  }



  double overstress_work(const Softening &softening,
                         const double     start,
                         const double     end,
                         const double     first,
                         const double     last)
  {
    return std::visit(
      [&](const auto &law) {
        const double stop = std::min(end, law.rupture_gap());
        if (!(stop > start))
          return 0.;
        return boost::math::quadrature::gauss<double, 7>::integrate(
          [&](const double kappa) {
            const double x =
              first + (last - first) * (kappa - start) / (end - start);
            return x * (2. + x) * loss_rate(law.on_curve(kappa), kappa);
          },
          start,
          stop);
      },
      softening);
  }
} // namespace demold

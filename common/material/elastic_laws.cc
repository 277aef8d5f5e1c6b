// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress, tangent and energy of the elastic laws in closed form.
#include "material/elastic_laws.h"

namespace demold
{
  void MooneyRivlin::add(const Deformation &x,
                         const bool         with_tangent,
                         ResponseSums      &sums) const
  {
    const double k = .5 * lambda * x.JJ_excess - mu1 - 2. * mu2;

    sums.stored += .5 * (mu1 * x.I1_excess + mu2 * x.I2_excess) +
                   .25 * lambda * (x.JJ_excess - x.log_JJ) -
                   (.5 * mu1 + mu2) * x.log_JJ;

    // (A2): mu1 1 + mu2 (I1 1 - C) + k C^-1
    add_scaled(sums.S, mu1 + mu2 * (3. + x.I1_excess), six_identity);
    add_scaled(sums.S, -mu2, x.C);
    add_scaled(sums.S, k, x.K);

    if (with_tangent)
      {
        // (A4)
        sums.one += 2. * mu2;
        sums.KK += lambda * (1. + x.JJ_excess);
        sums.K_square -= 2. * k;
      }
  }

  void IsochoricMooneyRivlin::add(const Deformation &x,
                                  const bool         with_tangent,
                                  ResponseSums      &sums) const
  {
    const double I1       = 3. + x.I1_excess;
    const double I2       = 3. + x.I2_excess;
    const double J_excess = x.JJ_excess / (1. + x.J);
    const double pp       = x.p * x.p;

    sums.stored +=
      C10 * (x.p * x.I1_excess + 3. * x.p_excess) +
      C01 * (pp * x.I2_excess + 3. * x.p_excess * (2. + x.p_excess)) +
      .5 * bulk * J_excess * J_excess;

    // dI1bar/dC = p (1 - I1/3 K), dI2bar/dC = p^2 (I1 1 - C - 2/3 I2 K)
    add_scaled(sums.S, 2. * (C10 * x.p + C01 * pp * I1), six_identity);
    add_scaled(sums.S, -2. * C01 * pp, x.C);
    add_scaled(sums.S,
               bulk * J_excess * x.J - 2. / 3. * C10 * x.p * I1 -
                 4. / 3. * C01 * pp * I2,
               x.K);

    if (with_tangent)
      {
        const double f1 = 4. * C10 * x.p;
        const double f2 = 4. * C01 * pp;
        sums.one += f2;
        sums.KK +=
          f1 * I1 / 9. + f2 * 4. / 9. * I2 + bulk * x.J * (x.J + J_excess);
        sums.K_square +=
          f1 * I1 / 3. + f2 * 2. / 3. * I2 - 2. * bulk * x.J * J_excess;
        add_scaled(sums.U, -f1 / 3. - 2. / 3. * f2 * I1, six_identity);
        add_scaled(sums.U, 2. / 3. * f2, x.C);
      }
  }
} // namespace demold

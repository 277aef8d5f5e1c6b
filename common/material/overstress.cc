// SPDX-License-Identifier: LGPL-2.1-or-later
// Stored and dissipated energy of a Maxwell branch without cancellation.
#include "material/overstress.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  Overstress::Overstress(const Nine &product)
    : M(product)
  {
    const double trace = product[0] + product[4] + product[8];
    for (const unsigned int i : {0, 4, 8})
      M[i] -= trace / 3.;
    square = trace_of_product(M, M);
    energy = trace - 3.;
    // Near equilibrium the difference above loses its digits. From
    // det(M + trace/3 1) = 1 follows an expansion that does not.
    if (square < 1e-6)
      energy = .5 * square - determinant(M);
    square = std::max(square, 0.);
    energy = std::max(energy, 0.);
    rate   = square;
  }

  Overstress Overstress::with_volume(const Nine &X, const double rate)
  {
    Overstress x;
    x.M      = X;
    x.square = std::max(0., trace_of_product(X, X));
    x.rate   = std::max(0., rate);

    const double trace = X[0] + X[4] + X[8];
    const double minor = .5 * (trace * trace - x.square);
    const double det   = trace + minor + determinant(X); // det b_e - 1
    // At the level of round-off only the leading term is worth something.
    x.energy =
      x.square < 1e-16 ? .5 * x.square : std::max(0., trace - std::log1p(det));
    return x;
  }

  double dissipation_over_step(const Overstress &start,
                               const Overstress &end,
                               const double      h)
  {
    const auto rate_factor = [](const Overstress &x) {
      return x.energy > 0. ? .5 * x.rate / x.energy : 1.;
    };
    const double H = .5 * h * (rate_factor(start) + rate_factor(end));

    const double x0x0 = start.energy, x1x1 = end.energy;
    double       x0x1 = 0.;
    if (start.square > 0. && end.square > 0.)
      {
        const double cosine = trace_of_product(start.M, end.M) /
                              std::sqrt(start.square * end.square);
        x0x1 = std::max(-1., std::min(1., cosine)) * std::sqrt(x0x0 * x1x1);
      }

    if (H < 2e-2)
      {
        const double even = H / 3. + H * H * H / 180.;
        const double odd  = H * H / 12. - H * H * H * H / 720.;
        return (even - odd) * x0x0 + (H / 3. - H * H * H / 90.) * x0x1 +
               (even + odd) * x1x1;
      }
    const double p     = -std::expm1(-H);
    const double E     = 1. - p;
    const double alpha = .5 * p * (1. + E) - 2. * E * p + E * E * H;
    const double beta  = (1. + E) * p - 2. * E * H;
    const double gamma = .5 * p * (1. + E) - 2. * p + H;
    return std::max(0., (alpha * x0x0 + beta * x0x1 + gamma * x1x1) / (p * p));
  }
} // namespace demold

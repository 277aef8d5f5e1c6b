// SPDX-License-Identifier: LGPL-2.1-or-later
// Weights of a quantity that follows a piecewise linear one with a delay.
#ifndef demold_material_fading_memory_h
#define demold_material_fading_memory_h

#include <cmath>

namespace demold
{
  /// y_n+1 = old y_n + start x_n + end x_n+1; all >= 0, of sum 1.
  struct MemoryWeights
  {
    double old, start, end;
  };

  /// The solution of y' = (x - y)/tau over a step of length h tau in which x
  /// moves linearly (theory A.2): with e = exp(-h) and q = (1-e)/h the weights
  /// are {e, q-e, 1-q}. Good to round-off for every @p h >= 0.
  inline MemoryWeights memory_weights(const double h)
  {
    const double e_less_one = std::expm1(-h);
    const double e          = 1. + e_less_one;
    if (h < 5e-3)
      return {e,
              h * (1. / 2. - h * (1. / 3. - h * (1. / 8. - h / 30.))),
              h * (1. / 2. - h * (1. / 6. - h * (1. / 24. - h / 120.)))};
    const double q = -e_less_one / h;
    return {e, q - e, 1. - q};
  }
} // namespace demold

#endif

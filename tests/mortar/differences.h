// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives by extrapolated central differences.
#ifndef demold_tests_mortar_differences_h
#define demold_tests_mortar_differences_h

#include <vector>

namespace mortar_tests
{
  /// Derivative of a vector-valued function at 0 (Richardson): errors of order
  /// h^4 and eps/h.
  template <typename Function>
  std::vector<double> derivative(const Function &f, const double h)
  {
    const auto central = [&f](const double step) {
      std::vector<double>       forward  = f(step);
      const std::vector<double> backward = f(-step);
      for (unsigned int i = 0; i < forward.size(); ++i)
        forward[i] = (forward[i] - backward[i]) / (2. * step);
      return forward;
    };
    const std::vector<double> coarse = central(h);
    std::vector<double>       fine   = central(0.5 * h);
    for (unsigned int i = 0; i < fine.size(); ++i)
      fine[i] += (fine[i] - coarse[i]) / 3.;
    return fine;
  }
} // namespace mortar_tests

#endif

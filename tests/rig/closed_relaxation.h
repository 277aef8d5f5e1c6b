// SPDX-License-Identifier: LGPL-2.1-or-later
// Finite relaxation of one isochoric branch, by the formulas of theory E.9.
#ifndef demold_tests_rig_closed_relaxation_h
#define demold_tests_rig_closed_relaxation_h

#include <cmath>

namespace demold
{
  /// s(t) of ds/dt = rate(s), s(0) = 0, by the classical Runge-Kutta method.
  template <class Rate>
  double integrate(const Rate &rate, const double end)
  {
    constexpr unsigned int n = 20000;
    const double           h = end / n;
    double                 s = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double k1 = rate(s), k2 = rate(s + .5 * h * k1),
                     k3 = rate(s + .5 * h * k2), k4 = rate(s + h * k3);
        s += h / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
      }
    return s;
  }

  /// Shear stress over mu at t/tau after a shear of @p gamma at once.
  inline double relaxed_shear(const double gamma, const double t_over_tau)
  {
    const auto d = [=](const double s) {
      return (1. + s) * (1. + s) + s * gamma * gamma;
    };
    const double s =
      integrate([&](const double s) { return std::cbrt((1. + s) * d(s)); },
                t_over_tau);
    return gamma * std::cbrt((1. + s) * d(s)) / d(s);
  }

  /// Cauchy stress over mu of incompressible rubber after a stretch of @p x.
  inline double relaxed_extension(const double x, const double t_over_tau)
  {
    const auto D = [=](const double s) {
      return std::cbrt((1. + s * x * x) * (1. + s / x) * (1. + s / x));
    };
    const double s = integrate(D, t_over_tau);
    return D(s) * (x * x / (1. + s * x * x) - 1. / (x + s));
  }

  /// Shear stress over mu of a branch of linear evolution (V2).
  inline double relaxed_shear_linear(const double gamma,
                                     const double t_over_tau)
  {
    const double e = std::exp(-t_over_tau);
    return gamma * e / (1. + e * (1. - e) * gamma * gamma);
  }
} // namespace demold

#endif

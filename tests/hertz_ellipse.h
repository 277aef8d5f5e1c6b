// SPDX-License-Identifier: LGPL-2.1-or-later
// The cylinder of hertz.prm on a rigid plane (Johnson 1985, chapter 4; theory
// E.6), and the ellipse that the pressures of a run are next to.
#ifndef demold_tests_hertz_ellipse_h
#define demold_tests_hertz_ellipse_h

#include "run_scene.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  /// Pressure over the contact of a cylinder.
  struct Ellipse
  {
    double half_width = 0., peak = 0.;
  };

  constexpr double line_load = .1, radius = 10.; // [N/mm], [mm]

  /// E* from the small-strain constants of theory A.1.
  inline Ellipse hertz(const double load = line_load)
  {
    const double lambda = 48.926 + 2. * .20134, G = .80537 + .20134;
    const double nu   = .5 * lambda / (lambda + G);
    const double star = 2. * G * (1. + nu) / (1. - nu * nu);
    const double a    = std::sqrt(4. * load * radius / (std::acos(-1.) * star));
    return {a, 2. * load / (std::acos(-1.) * a)};
  }

  /// Least squares of p^2 = p_0^2 (1 - x^2/a^2) over the points in contact.
  inline Ellipse fit(const CsvTable &points)
  {
    double n = 0., X = 0., Y = 0., XX = 0., XY = 0.;
    for (std::size_t i = 0; i < points.n_rows(); ++i)
      if (points["pressure [MPa]"][i] > 1e-9)
        {
          const double x = std::pow(points["x [mm]"][i], 2);
          const double y = std::pow(points["pressure [MPa]"][i], 2);
          n += 1.;
          X += x;
          Y += y;
          XX += x * x;
          XY += x * y;
        }
    const double slope = (n * XY - X * Y) / (n * XX - X * X);
    const double peak2 = (Y - slope * X) / n;
    return {std::sqrt(-peak2 / slope), std::sqrt(peak2)};
  }

  inline double largest_pressure(const CsvTable &points)
  {
    const auto &p = points["pressure [MPa]"];
    return *std::max_element(p.begin(), p.end());
  }
} // namespace demold

#endif

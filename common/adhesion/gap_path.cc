// SPDX-License-Identifier: LGPL-2.1-or-later
// What a bond loses along a straight path of its gap when modes are mixed.
#include "adhesion/gap_path.h"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    struct Components
    {
      double       opening;
      Tensor<1, 3> slip;
    };

    Components components(const GapPath &path, const double fraction)
    {
      const Tensor<1, 3> gap = path.start + fraction * (path.end - path.start);
      const double       opening = gap * path.normal;
      return {std::max(opening, 0.), gap - opening * path.normal};
    }



    // Integral over fractions between which g_N keeps its sign: there the
    // effective gap squared is A ((x - x_0)^2 + w^2). With x = x_0 + w sinh u
    // modes turn by pi over about two units of u, however near the path comes
    // to no gap at all.
    template <typename Rate>
    double integral(const GapPath &path,
                    const Rate    &rate,
                    const double   from,
                    const double   to)
    {
      const double middle = 0.5 * (from + to);
      const double A      = path.curvature(middle);
      if (!(to > from) || A <= 0.)
        return 0.;
      const double away = 0.5 * path.effective_squared_rate(middle) / A;
      const double x_0  = middle - away;
      const double w =
        std::max(std::sqrt(
                   std::max(path.effective_squared(middle) / A - away * away,
                            0.)),
                 1e-8 * (to - from));
      const double first  = std::asinh((from - x_0) / w);
      const double last   = std::asinh((to - x_0) / w);
      const double pieces = std::ceil((last - first) / 2.);
      const double width  = (last - first) / pieces;
      double       sum    = 0.;
      for (double piece = 0.; piece < pieces; ++piece)
        sum += boost::math::quadrature::gauss<double, 15>::integrate(
          [&](const double u) {
            return rate(x_0 + w * std::sinh(u)) * w * std::cosh(u);
          },
          first + piece * width,
          first + (piece + 1.) * width);
      return sum;
    }
  } // namespace



  double GapPath::effective_squared(const double fraction) const
  {
    const Components at = components(*this, fraction);
    return at.opening * at.opening +
           factors.b * factors.b * at.slip.norm_square();
  }



  double GapPath::effective_squared_rate(const double fraction) const
  {
    const Components   at       = components(*this, fraction);
    const Tensor<1, 3> step     = end - start;
    const double       opening  = step * normal;
    const double       slipping = at.slip * step;
    return 2. * (at.opening * opening + factors.b * factors.b * slipping);
  }



  double GapPath::curvature(const double fraction) const
  {
    const Components   at      = components(*this, fraction);
    const Tensor<1, 3> step    = end - start;
    const double       opening = step * normal;
    const Tensor<1, 3> slip    = step - opening * normal;
    return (at.opening > 0. ? opening * opening : 0.) +
           factors.b * factors.b * slip.norm_square();
  }



  double GapPath::mode_ratio(const double fraction) const
  {
    const Components at      = components(*this, fraction);
    const double     opening = at.opening * at.opening;
    const double     slip    = at.slip.norm_square();
    return (opening + factors.a * slip) /
           (opening + factors.b * factors.b * slip);
  }



  double GapPath::reaches(const double kappa) const
  {
    // Newton from the end: convex, so it comes down to the root and stops.
    double fraction = 1.;
    for (unsigned int i = 0; i < 100; ++i)
      {
        const double excess = effective_squared(fraction) - kappa * kappa;
        const double rate   = effective_squared_rate(fraction);
        if (excess <= 0. || rate <= 0.)
          break;
        const double next = std::max(0., fraction - excess / rate);
        if (!(next < fraction))
          break;
        fraction = next;
      }
    return fraction;
  }



  double decohesion_work(const GapPath   &path,
                         const Softening &softening,
                         const double     kappa_old,
                         const double     lost)
  {
    return std::visit(
      [&](const auto &law) {
        const double kappa_end = std::sqrt(path.effective_squared(1.));
        const double last =
          kappa_end > law.rupture_gap() ? path.reaches(law.rupture_gap()) : 1.;
        const double first =
          std::min(last, path.reaches(std::max(kappa_old, law.onset_gap())));
        const double ratio = path.mode_ratio(last);

        const auto rate = [&](const double fraction) {
          const double kappa      = std::sqrt(path.effective_squared(fraction));
          const SofteningPoint at = law.on_curve(kappa);
          return (path.mode_ratio(fraction) - ratio) * 0.5 *
                 (at.limit - at.slope * kappa) *
                 path.effective_squared_rate(fraction) / (2. * kappa);
        };
        // Halves in the order of the path: it may cross g_N = 0, a kink.
        const double start   = path.start * path.normal;
        const double end     = path.end * path.normal;
        const double closing = start * end < 0. ? start / (start - end) : first;
        const double middle  = std::clamp(closing, first, last);
        return ratio * lost + integral(path, rate, first, middle) +
               integral(path, rate, middle, last);
      },
      softening);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// The tangential gap of a point under pressure: bond, friction, augmentation.
#include "adhesion/sliding_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demold
{
  using namespace dealii;

  namespace
  {
    Tensor<2, 3> identity()
    {
      Tensor<2, 3> one;
      for (unsigned int d = 0; d < 3; ++d)
        one[d][d] = 1.;
      return one;
    }



    // b |g_T| of the slide with the secant stiffness of kappa is kappa where
    // the point softens; theory C.4, row "slide, decohesion", which has one
    // solution under C8. Its excess falls from positive at kappa_n to negative
    // at the softening that friction would not hinder but help.
    double softened_gap(const PressedPoint   &p,
                        const PointSoftening &softening,
                        const double          kappa_old)
    {
      const double a = p.factors.a, b = p.factors.b;
      double       low  = kappa_old;
      double       high = std::max(
        low,
        radial_gap(softening, p.c, b / a * (p.traction.norm() + p.limit)).gap);
      double kappa = high;
      for (unsigned int i = 0; i < 200; ++i)
        {
          const SofteningPoint at        = softening.at(kappa);
          const double         stiffness = at.limit / kappa;
          const TangentialGap  g         = slide(p, stiffness);
          const double         length    = g.gap.norm();
          const double         excess    = b * length - kappa;
          (excess > 0. ? low : high)     = kappa;

          double rate = -1.;
          if (g.slides && length > 0.)
            rate += a * b * (stiffness - at.slope) / kappa / length *
                    (g.gap * (g.by_traction * g.gap));
          double next = kappa - excess / rate;
          if (!(rate < 0. && next >= low && next <= high))
            next = 0.5 * (low + high);
          if (std::abs(next - kappa) <=
              2. * std::numeric_limits<double>::epsilon() * kappa)
            break;
          kappa = next;
        }
      return kappa;
    }
  } // namespace



  TangentialGap stuck(const PressedPoint &p)
  {
    TangentialGap g;
    g.gap      = p.start;
    g.by_start = identity();
    return g;
  }



  TangentialGap slide(const PressedPoint &p, const double stiffness)
  {
    const double       D    = p.factors.a * (p.c + stiffness);
    const Tensor<1, 3> pull = p.traction - D * p.start;
    const double       size = pull.norm();
    if (p.limit > 0. && size <= p.limit)
      {
        TangentialGap g = stuck(p);
        g.used          = size / p.limit;
        return g;
      }
    TangentialGap g;
    g.slides           = true;
    const double share = size > 0. ? 1. - p.limit / size : 1.;
    if (size > 0.)
      g.direction = pull / size;
    g.gap         = p.start + share / D * pull;
    g.by_traction = share / D * identity() +
                    (1. - share) / D * outer_product(g.direction, g.direction);
    g.by_limit = -1. / D * g.direction;
    g.by_start = identity() - D * g.by_traction;
    return g;
  }



  TangentialGap radial_slide(const PressedPoint   &p,
                             const PointSoftening &softening,
                             const SlideAxis       axis)
  {
    const bool         along_start = axis == SlideAxis::start;
    const Tensor<1, 3> along       = along_start ? p.start : p.traction;
    const double       length      = along.norm();
    const Tensor<1, 3> e           = along / length;
    const double       a = p.factors.a, b = p.factors.b;
    const RadialGap    radial =
      radial_gap(softening, p.c, b / a * (p.traction * e - p.limit));
    const double rate = radial.rate / a;

    const Tensor<2, 3> turn =
      (radial.gap / b * identity() + rate * outer_product(e, p.traction)) *
      (identity() - outer_product(e, e)) / length;
    TangentialGap g;
    g.slides      = true;
    g.direction   = e;
    g.gap         = radial.gap / b * e;
    g.by_traction = rate * outer_product(e, e);
    (along_start ? g.by_start : g.by_traction) += turn;
    g.by_limit  = -rate * e;
    g.effective = radial.gap;
    return g;
  }



  TangentialGap softening_slide(const PressedPoint   &p,
                                const PointSoftening &softening,
                                const double          kappa_old)
  {
    const double         kappa = softened_gap(p, softening, kappa_old);
    const SofteningPoint at    = softening.at(kappa);
    TangentialGap        g     = slide(p, at.limit / kappa);
    g.effective                = kappa;
    // by_traction is the inverse of H but for the change of the secant,
    // a (s' - s/kappa) e e, which is of rank one: Sherman and Morrison.
    const Tensor<1, 3> e      = g.gap / g.gap.norm();
    const double       change = p.factors.a * (at.slope - at.limit / kappa);
    const Tensor<1, 3> He     = g.by_traction * e;
    const Tensor<2, 3> less =
      change / (1. + change * (e * He)) * outer_product(He, e);
    g.by_traction -= less * g.by_traction;
    g.by_limit -= less * g.by_limit;
    g.by_start -= less * g.by_start;
    return g;
  }
} // namespace demold

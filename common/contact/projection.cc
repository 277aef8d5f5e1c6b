// SPDX-License-Identifier: LGPL-2.1-or-later
// Newton projection of a point onto a facet.
#include "contact/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Newton step of thesis (3.6). Where the distance is not convex the
    /// curvature term is left out; the step then still leads downhill.
    FacetCoordinates projection_step(const FacetFrame   &frame,
                                     const Tensor<1, 3> &d,
                                     const unsigned int  n_nodes)
    {
      const double F1 = d * frame.a[0], H11 = frame.a[0].norm_square();
      if (n_nodes == 2)
        return {{F1 / H11, 0.}};
      const double F2 = d * frame.a[1], H22 = frame.a[1].norm_square();
      const double metric_12 = frame.a[0] * frame.a[1];
      const double metric    = H11 * H22 - metric_12 * metric_12;

      double H12 = metric_12 - d * frame.twist;
      double det = H11 * H22 - H12 * H12;
      if (det < 1e-6 * metric)
        {
          H12 = metric_12;
          det = metric;
        }
      return {{(H22 * F1 - H12 * F2) / det, (H11 * F2 - H12 * F1) / det}};
    }

    double largest(const FacetCoordinates &xi)
    {
      return std::max(std::abs(xi[0]), std::abs(xi[1]));
    }

    /// Shortens a step until the distance decreases sufficiently.
    FacetCoordinates damped(FacetCoordinates        step,
                            const FacetCoordinates &xi,
                            const Point<3>         &point,
                            const FacetPositions   &facet,
                            const FacetFrame       &frame)
    {
      const Tensor<1, 3> d   = point - frame.x;
      const double       phi = 0.5 * d.norm_square();
      const double       cut = std::min(1., 2. / largest(step));
      step                   = {{cut * step[0], cut * step[1]}};
      for (unsigned int halving = 0; halving < 12; ++halving)
        {
          const double slope =
            d * (step[0] * frame.a[0] + step[1] * frame.a[1]);
          const FacetCoordinates next{{xi[0] + step[0], xi[1] + step[1]}};
          const double           phi_next =
            0.5 * (point - facet_frame(facet, next).x).norm_square();
          if (largest(step) < 1e-6 || phi_next <= phi - 1e-4 * slope)
            break;
          step = {{0.5 * step[0], 0.5 * step[1]}};
        }
      return step;
    }
  } // namespace

  Projection project(const Point<3> &point, const FacetPositions &facet)
  {
    constexpr unsigned int max_iterations = 20;
    constexpr double       eps = std::numeric_limits<double>::epsilon();

    Projection result;
    FacetFrame frame = facet_frame(facet, result.xi);
    for (unsigned int k = 0; k < max_iterations && !result.found; ++k)
      {
        if (frame.normal.norm_square() == 0. || largest(result.xi) > 10.)
          return result;
        const Tensor<1, 3> d    = point - frame.x;
        FacetCoordinates   step = projection_step(frame, d, facet.n_nodes);

        // Rounding of the positions alone moves the foot by this much.
        const double noise =
          8. * eps * (point.norm() + d.norm()) /
          std::min(frame.a[0].norm(),
                   facet.n_nodes == 2 ? frame.a[0].norm() : frame.a[1].norm());
        result.found = largest(step) <= 1e-12 + noise;
        if (!result.found && facet.n_nodes == 4)
          step = damped(step, result.xi, point, facet, frame);
        result.xi = {{result.xi[0] + step[0], result.xi[1] + step[1]}};
        frame     = facet_frame(facet, result.xi);
      }
    result.x      = frame.x;
    result.normal = frame.normal;
    result.gap    = frame.normal * (point - frame.x);
    return result;
  }
} // namespace demold

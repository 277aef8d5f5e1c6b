// SPDX-License-Identifier: LGPL-2.1-or-later
// Path constraint: one point always opens.
#include "solution/largest_opening_constraint.h"

#include "solution/softening_overview.h"
#include "weak_form/weak_form.h"

#include <algorithm>

namespace demold
{
  namespace
  {
    double opening(const SofteningSite &point)
    {
      return point.driven ? point.effective - point.largest : -1e300;
    }
  } // namespace

  std::string LargestOpeningConstraint::name() const
  {
    return "largest opening";
  }

  void LargestOpeningConstraint::start(const WeakForm &weak_form,
                                       const double    size)
  {
    double range = 0., left = 0.;
    for (const SofteningSite &point : softening_sites(weak_form))
      if (point.driven)
        {
          range = std::max(range, point.rupture - point.onset);
          left  = std::max(left, point.rupture - point.largest);
        }
    s = std::min(size * max_over_ranks(weak_form, range),
                 max_over_ranks(weak_form, left));
  }

  double LargestOpeningConstraint::value(const WeakForm &weak_form,
                                         const unsigned int) const
  {
    double largest = -1e300;
    for (const SofteningSite &point : softening_sites(weak_form))
      largest = std::max(largest, opening(point));
    return max_over_ranks(weak_form, largest) - s;
  }

  /// Where several open alike, all of them: their mean.
  void LargestOpeningConstraint::add_gradient(const WeakForm &weak_form,
                                              const unsigned int,
                                              Vector &h) const
  {
    const double largest = value(weak_form, 0) + s;
    const auto   points  = softening_sites(weak_form);
    const auto   leads   = [&](const SofteningSite &point) {
      return opening(point) >= largest - 1e-9 * s;
    };
    const double n =
      sum_over_ranks(weak_form,
                     std::count_if(points.begin(), points.end(), leads));
    for (const SofteningSite &point : points)
      if (leads(point))
        add_gap_gradient(point, point.direction, 1. / n, h);
    h.compress(dealii::VectorOperation::add);
  }

  double LargestOpeningConstraint::tolerance() const
  {
    return 1e-7 * s;
  }
} // namespace demold

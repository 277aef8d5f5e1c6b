// SPDX-License-Identifier: LGPL-2.1-or-later
// Path constraint: how much energy the softening points release in a step.
#include "solution/dissipation_constraint.h"

#include "solution/softening_overview.h"
#include "weak_form/weak_form.h"

#include <algorithm>

namespace demold
{
  namespace
  {
    /// A point that has let go releases no more than it had, as long as others
    /// are left that can go on.
    bool is_used_up(const SofteningSite &point)
    {
      return point.driven && point.separated;
    }

    bool all_used_up(const WeakForm                   &weak_form,
                     const std::vector<SofteningSite> &points)
    {
      double going_on = 0.;
      for (const SofteningSite &point : points)
        if (point.driven && !point.separated)
          going_on = 1.;
      return max_over_ranks(weak_form, going_on) == 0.;
    }
  } // namespace

  std::string DissipationConstraint::name() const
  {
    return "dissipation";
  }

  void DissipationConstraint::start(const WeakForm &weak_form,
                                    const double    size)
  {
    double largest = 0., left = 0.;
    for (const SofteningSite &point : softening_sites(weak_form))
      if (point.driven)
        {
          largest = std::max(largest, point.whole);
          left += point.left;
        }
    step = std::min(size * max_over_ranks(weak_form, largest),
                    sum_over_ranks(weak_form, left));
  }

  double DissipationConstraint::value(const WeakForm &weak_form,
                                      const unsigned int) const
  {
    const auto points  = softening_sites(weak_form);
    const bool nothing = all_used_up(weak_form, points);
    double     sum     = 0.;
    for (const SofteningSite &point : points)
      sum += is_used_up(point) && !nothing ? point.left : point.released;
    return sum_over_ranks(weak_form, sum) - step;
  }

  void DissipationConstraint::add_gradient(const WeakForm &weak_form,
                                           const unsigned int,
                                           Vector &h) const
  {
    const auto points  = softening_sites(weak_form);
    const bool nothing = all_used_up(weak_form, points);
    for (const SofteningSite &point : points)
      if (!is_used_up(point) || nothing)
        add_gap_gradient(point, point.released_gradient, 1., h);
    h.compress(dealii::VectorOperation::add);
  }

  double DissipationConstraint::tolerance() const
  {
    return 1e-7 * step;
  }
} // namespace demold

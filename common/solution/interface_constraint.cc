// SPDX-License-Identifier: LGPL-2.1-or-later
// Path constraint: a length in the space of the gaps that drive the softening.
#include "solution/interface_constraint.h"

#include "solution/softening_overview.h"
#include "weak_form/weak_form.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  std::string InterfaceConstraint::name() const
  {
    return "interface";
  }

  void InterfaceConstraint::start(const WeakForm &weak_form, const double size)
  {
    const auto points = softening_sites(weak_form);
    double     areas = 0., range = 0.;
    for (const SofteningSite &point : points)
      if (point.driven)
        {
          areas += point.area;
          range = std::max(range, point.rupture - point.onset);
        }
    area = sum_over_ranks(weak_form, areas);
    s    = size * max_over_ranks(weak_form, range);

    direction.clear();
    double squares = 0.;
    for (const SofteningSite &point : points)
      if (point.driven)
        {
          const auto   last = last_change.find(point.unknowns.front());
          Tensor<1, 3> d    = point.direction;
          if (last != last_change.end() && last->second * point.direction > 0.)
            d = last->second;
          else if (!last_change.empty())
            d *= .1 * s;
          direction[point.unknowns.front()] = d;
          squares += point.area / area * d.norm_square();
        }
    length = std::sqrt(std::max(sum_over_ranks(weak_form, squares), 1e-300));
  }

  Tensor<1, 3> InterfaceConstraint::along(const SofteningSite &point,
                                          const unsigned int   iteration) const
  {
    const double weight = point.area / area;
    return iteration == 0 ?
             direction.at(point.unknowns.front()) * (weight / length) :
             (point.gap - point.old_gap) * (weight / s);
  }

  double InterfaceConstraint::value(const WeakForm    &weak_form,
                                    const unsigned int iteration) const
  {
    double sum = 0.;
    for (const SofteningSite &point : softening_sites(weak_form))
      if (point.driven)
        sum += along(point, iteration) * (point.gap - point.old_gap);
    sum = sum_over_ranks(weak_form, sum);
    return iteration == 0 ? sum - s : .5 * (sum - s);
  }

  void InterfaceConstraint::add_gradient(const WeakForm    &weak_form,
                                         const unsigned int iteration,
                                         Vector            &h) const
  {
    for (const SofteningSite &point : softening_sites(weak_form))
      if (point.driven)
        add_gap_gradient(point, along(point, iteration), 1., h);
    h.compress(VectorOperation::add);
  }

  double InterfaceConstraint::tolerance() const
  {
    return 1e-7 * s;
  }

  void InterfaceConstraint::accepted(const WeakForm &weak_form)
  {
    last_change.clear();
    for (const SofteningSite &point : softening_sites(weak_form))
      last_change[point.unknowns.front()] = point.gap - point.old_gap;
  }
} // namespace demold

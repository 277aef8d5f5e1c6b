// SPDX-License-Identifier: LGPL-2.1-or-later
// Path constraint: a length in the space of all free unknowns.
#include "solution/cylindrical_constraint.h"

#include "weak_form/weak_form.h"

#include <algorithm>

namespace demold
{
  Vector free_increment(const WeakForm &weak_form)
  {
    Vector du(weak_form.trial);
    du -= weak_form.accepted;
    weak_form.set_supports_to_zero(du);
    return du;
  }

  std::string CylindricalConstraint::name() const
  {
    return "cylindrical";
  }

  void CylindricalConstraint::start(const WeakForm &weak_form,
                                    const double    size)
  {
    s         = size * length;
    direction = weak_form.last_increment();
    weak_form.set_supports_to_zero(direction);
    direction /= std::max(direction.l2_norm(), 1e-300);
  }

  double CylindricalConstraint::value(const WeakForm    &weak_form,
                                      const unsigned int iteration) const
  {
    const Vector du = free_increment(weak_form);
    return iteration == 0 ? direction * du - s : (du * du - s * s) / (2. * s);
  }

  void CylindricalConstraint::add_gradient(const WeakForm    &weak_form,
                                           const unsigned int iteration,
                                           Vector            &h) const
  {
    if (iteration == 0)
      h += direction;
    else
      h.add(1. / s, free_increment(weak_form));
  }

  double CylindricalConstraint::tolerance() const
  {
    return 1e-7 * s;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// The longest step at which central differences are stable.
#ifndef demold_solution_critical_step_h
#define demold_solution_critical_step_h

#include "weak_form/algebra.h"

namespace demold
{
  class WeakForm;

  /// Largest eigenvalue [1/s^2] of M^-1 K over the unknowns with mass, by the
  /// power method from a fixed start, to 1e-4 or 500 products with K. A lower
  /// bound. Collective.
  double largest_eigenvalue(const SparseMatrix &K, const Vector &mass);

  /// 2/omega [s] of the accepted state of @p weak_form, with omega^2 the
  /// largest eigenvalue of M^-1 K. The tangent is assembled: rubber at once
  /// as stiff as in a step of @p dt [s], contact, friction and bonds in their
  /// present state are all in it. Leaves the state as it was. @p mass [t] is
  /// that of all unknowns. Theory D.4 gives estimates of it, l_e/c_d of the
  /// rubber and 2/sqrt(2 gamma A_s/m) of a bond.
  double critical_step(WeakForm     &weak_form,
                       const Vector &mass,
                       const double  dt);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Is the equilibrium stable? Signs of the tangent's pivots.
#include "solution/stability_monitor.h"

#include "solution/linear_solver.h"
#include "weak_form/weak_form.h"

namespace demold
{
  StabilityReading read_stability(WeakForm          &weak_form,
                                  LinearSolver      &linear_solver,
                                  const unsigned int iteration)
  {
    weak_form.assemble(true, iteration);
    // Any right-hand side will do: only the factor counts.
    Vector b(weak_form.new_vector());
    b = 1.;
    Vector x(b);
    linear_solver.solve(weak_form.matrix,
                        x,
                        b,
                        .5,
                        weak_form.symmetric(),
                        weak_form.has_extra_unknowns());
    StabilityReading reading;
    reading.negative_pivots  = linear_solver.n_negative_pivots();
    reading.determinant_sign = linear_solver.determinant_sign();
    return reading;
  }
} // namespace demold

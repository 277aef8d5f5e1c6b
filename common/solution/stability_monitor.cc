// SPDX-License-Identifier: LGPL-2.1-or-later
// Is the equilibrium stable? Signs of the tangent's pivots.
#include "solution/stability_monitor.h"

#include "solution/linear_solver.h"
#include "weak_form/weak_form.h"

#include <cmath>

namespace demold
{
  namespace
  {
    constexpr unsigned int most_inverse_iterations = 60;

    /// Change of the eigenvalue over itself that ends the iteration.
    constexpr double eigenvalue_tolerance = 1e-6;

    /// Inverse iteration with the factor at hand. The start has no symmetry
    /// that an eigenvector could miss.
    double find_smallest_eigenvalue(const WeakForm &weak_form,
                                    LinearSolver   &linear_solver,
                                    Vector         &mode)
    {
      Vector x(weak_form.new_vector());
      for (const auto i : x.locally_owned_elements())
        x(i) = 1. + .5 * std::sin(1. + static_cast<double>(i));
      x.compress(dealii::VectorOperation::insert);
      weak_form.set_supports_to_zero(x);
      double last = 0.;
      for (unsigned int k = 0; k < most_inverse_iterations; ++k)
        {
          x /= x.l2_norm();
          Vector y(x);
          if (linear_solver.solve_again(weak_form.matrix, y, x, 1e-10) !=
              LinearSolver::Outcome::solved)
            return 0.;
          const double value = 1. / (x * y);
          if (std::abs(value - last) <= eigenvalue_tolerance * std::abs(value))
            {
              mode = y;
              mode /= y.l2_norm();
              return value;
            }
          last = value;
          x    = y;
          weak_form.set_supports_to_zero(x);
        }
      return 0.;
    }
  } // namespace

  StabilityReading read_stability(WeakForm          &weak_form,
                                  LinearSolver      &linear_solver,
                                  const unsigned int iteration,
                                  Vector            *mode)
  {
    weak_form.assemble(true, iteration);
    // Any right-hand side will do: only the factor counts.
    Vector b(weak_form.new_vector());
    b = 1.;
    Vector           x(b);
    const auto       outcome = linear_solver.solve(weak_form.matrix,
                                             x,
                                             b,
                                             .5,
                                             weak_form.symmetric(),
                                             weak_form.has_extra_unknowns());
    StabilityReading reading;
    if (mode != nullptr)
      *mode = 0.;
    if (mode != nullptr && outcome == LinearSolver::Outcome::solved &&
        !weak_form.has_extra_unknowns())
      reading.smallest_eigenvalue =
        find_smallest_eigenvalue(weak_form, linear_solver, *mode);
    reading.negative_pivots  = linear_solver.n_negative_pivots();
    reading.determinant_sign = linear_solver.determinant_sign();
    return reading;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// A system with one row and one column more is solved also where its larger
// block is singular, or nearly. Written for any number of ranks.
#include "solution/bordered_system.h"

#include "solution/block_stiffness.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr unsigned int n = 30;

    /// Smallest eigenvalue of the chain.
    double smallest_eigenvalue()
    {
      const double angle = std::acos(-1.) / (n + 1);
      return 2. - 2. * std::cos(angle);
    }

    /// Largest residual of the bordered equations for a chain whose smallest
    /// eigenvalue is moved to @p remains.
    double residual(const double remains)
    {
      const double shift = smallest_eigenvalue() - remains;
      TestSystem   system(n, 0, chain(n));
      system.fill(chain(n), [shift](unsigned int i, unsigned int j) {
        return i == j ? 2. - shift : -1.;
      });
      system.make_right_hand_side();
      Vector f(system.b), h(system.b), r(system.b);
      for (const auto i : system.owned)
        {
          f(i) = 1. + .01 * i;
          h(i) = i == n / 2 ? 1. : 0.;
        }
      f.compress(dealii::VectorOperation::insert);
      h.compress(dealii::VectorOperation::insert);

      LinearSolverParameters parameters;
      LinearSolver           solver(parameters, MPI_COMM_WORLD);
      const double           w = .5, c = -2.;
      const BorderedSolution x =
        solve_bordered({system.A, f, h, w, r, c}, solver, true, false);
      EXPECT_TRUE(x.solved);
      Vector above(r);
      system.A.residual(above, x.du, r);
      above.add(x.dt, f);
      return std::max(above.linfty_norm(), std::abs(h * x.du + w * x.dt + c));
    }
  } // namespace

  TEST(BorderedSystem, is_solved_where_the_tangent_is_regular)
  {
    EXPECT_LT(residual(.3), 1e-10);
    EXPECT_LT(residual(-.1), 1e-10);
  }

  TEST(BorderedSystem, is_solved_at_a_limit_point_and_next_to_it)
  {
    for (const double remains : {0., 1e-16, 1e-14, 1e-12, 1e-9, -1e-12})
      EXPECT_LT(residual(remains), 1e-7) << remains;
  }
} // namespace demold

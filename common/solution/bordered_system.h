// SPDX-License-Identifier: LGPL-2.1-or-later
// A linear system with one row and one column more.
#ifndef demold_solution_bordered_system_h
#define demold_solution_bordered_system_h

#include "solution/linear_solver.h"
#include "weak_form/algebra.h"

namespace demold
{
  /// [K -f; h w] (du, dt) = (r, -c): the linear equations of a step along a
  /// path (theory D2).
  struct BorderedSystem
  {
    const SparseMatrix &K;
    const Vector       &f; ///< - dR/dt
    const Vector       &h; ///< dc/du
    double              w; ///< dc/dt
    const Vector       &r; ///< - R
    double              c;
  };

  struct BorderedSolution
  {
    bool   solved = false;
    double dt     = 0.;
    Vector du;
  };

  /// By two right-hand sides with one factor of K. At limit points K is
  /// singular, near them its factor is worthless: where the solution leaves a
  /// residual, the system is solved as a whole.
  BorderedSolution solve_bordered(const BorderedSystem &system,
                                  LinearSolver         &linear_solver,
                                  const bool            symmetric,
                                  const bool            has_extra_rows);

  /// The system as a whole, by a factor of its own.
  BorderedSolution solve_whole(const BorderedSystem &system);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Is the equilibrium stable? Signs of the tangent's pivots.
#ifndef demold_solution_stability_monitor_h
#define demold_solution_stability_monitor_h

#include "weak_form/algebra.h"

namespace demold
{
  class LinearSolver;
  class WeakForm;

  /// What a factor of the tangent tells (theory D.3).
  struct StabilityReading
  {
    /// Negative eigenvalues (Sylvester): 0 stable, 1 beyond a limit point, more
    /// after a bifurcation; -1 unknown: the tangent is unsymmetric or singular.
    int negative_pivots = -1;

    /// Sign of the determinant; 0 where it is singular.
    int determinant_sign = 0;

    /// [N/mm] of the free unknowns, the one nearest to zero, by inverse
    /// iteration; 0 where it was not asked for or not found.
    double smallest_eigenvalue = 0.;
  };

  /// Factorises the tangent at the trial, whose residual was the last to be
  /// assembled in iteration @p iteration. Costs an assembly and a factor, so
  /// that it is only called where somebody asks; some ten solutions more with
  /// @p mode, which becomes the eigenvector of the smallest eigenvalue, of norm
  /// 1 or, where none is found, 0: saddle points have none.
  StabilityReading read_stability(WeakForm          &weak_form,
                                  LinearSolver      &linear_solver,
                                  const unsigned int iteration,
                                  Vector            *mode);
} // namespace demold

#endif

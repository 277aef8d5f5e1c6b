// SPDX-License-Identifier: LGPL-2.1-or-later
// SUNDIALS' nonlinear solver on a weak form, as an alternative to Newton.
#ifndef demold_solution_kinsol_h
#define demold_solution_kinsol_h

#include "solution/nonlinear_solver.h"
#include "weak_form/algebra.h"

namespace demold
{
  /// KINSOL with line search; an assembled tangent is kept for up to ten
  /// iterations while it serves (modified Newton), though it is factorised
  /// again in each. The first correction, which brings the
  /// supports to their places, is a full Newton step. Converged when the
  /// largest unbalanced force is below `residual tolerance` times the same
  /// scale as in Newton.
  class Kinsol : public NonlinearSolver
  {
  public:
    Kinsol(const NewtonParameters &parameters, LinearSolver &linear_solver);

    NewtonReport solve(WeakForm &weak_form) override;

  private:
    bool assemble(WeakForm &weak_form, bool tangent, NewtonReport &report);
    bool first_step(WeakForm &weak_form, NewtonReport &report);

    const NewtonParameters parameters;
    LinearSolver &         linear_solver;
    double                 scale = 0.; ///< [N] of the last assembly
  };
} // namespace demold

#endif

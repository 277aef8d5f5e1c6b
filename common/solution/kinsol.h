// SPDX-License-Identifier: LGPL-2.1-or-later
// SUNDIALS' nonlinear solver on a weak form, as an alternative to Newton.
#ifndef demold_solution_kinsol_h
#define demold_solution_kinsol_h

#include "solution/nonlinear_solver.h"
#include "weak_form/algebra.h"

namespace demold
{
  /// KINSOL with line search; a tangent and its factor are kept for up to ten
  /// iterations while they serve (modified Newton). The first correction, which
  /// brings the supports to their places, is a full Newton step. Converged when
  /// the largest unbalanced force is below `residual tolerance` times the same
  /// scale as in Newton.
  class Kinsol : public NonlinearSolver
  {
  public:
    Kinsol(const NewtonParameters &parameters, LinearSolver &linear_solver);

    NewtonReport solve(WeakForm &weak_form) override;

    /// Tangents assembled since construction: those of the first corrections
    /// and those that KINSOL asked for.
    unsigned int n_tangents = 0;

  private:
    /// What there is in the matrix of the weak form.
    enum class Tangent
    {
      lost, ///< nothing: a change of its pattern has emptied it
      fresh,
      used ///< solved with before, unchanged since
    };

    bool assemble(WeakForm &weak_form, bool with_tangent, NewtonReport &report);
    bool correct(WeakForm     &weak_form,
                 Vector       &correction,
                 const Vector &right_hand_side,
                 NewtonReport &report);
    bool first_step(WeakForm &weak_form, NewtonReport &report);

    const NewtonParameters parameters;
    LinearSolver          &linear_solver;
    double                 scale          = 0.; ///< [N] of the last assembly
    unsigned int           pattern_number = 0;
    Tangent                tangent        = Tangent::lost;
  };
} // namespace demold

#endif

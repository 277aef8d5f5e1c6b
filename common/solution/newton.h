// SPDX-License-Identifier: LGPL-2.1-or-later
// Newton's method on a weak form; it knows no mechanics.
#ifndef demold_solution_newton_h
#define demold_solution_newton_h

#include "solution/nonlinear_solver.h"
#include "solution/residual_measure.h"
#include "weak_form/algebra.h"

namespace demold
{
  /// Solves R(u) = 0 from the trial of the weak form. An increment has
  /// converged when the unbalanced force is below `residual tolerance` times
  /// the largest of bulk, interface and inertia forces (ResidualMeasure) and
  /// the work of the last correction is below `energy tolerance` times that of
  /// the largest one; a tenth of the residual tolerance alone will do, and
  /// after 8 iterations the residual tolerance itself.
  class Newton : public NonlinearSolver
  {
  public:
    Newton(const NewtonParameters &parameters, LinearSolver &linear_solver);

    NewtonReport solve(WeakForm &weak_form) override;

  private:
    bool   assemble(WeakForm &, bool tangent, NewtonReport &);
    bool   has_converged(const NewtonReport &) const;
    double forcing_term(const NewtonReport &report) const;
    void   search_line(WeakForm &, const Vector &du, NewtonReport &);

    const NewtonParameters parameters;
    LinearSolver          &linear_solver;
    ResidualMeasure        measure;
    double                 largest_work = 0.; ///< of a correction [mJ]
    double                 last_work    = 0.;
    Vector                 correction;
    unsigned int           pattern_number = 0;
  };
} // namespace demold

#endif

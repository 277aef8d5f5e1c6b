// SPDX-License-Identifier: LGPL-2.1-or-later
// Newton's method on a weak form; it knows no mechanics.
#ifndef demold_solution_newton_h
#define demold_solution_newton_h

#include "weak_form/algebra.h"

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  class LinearSolver;
  class WeakForm;

  /// Entries of section Solver that belong to Newton.
  struct NewtonParameters
  {
    unsigned int max_iterations     = 25;
    double       residual_tolerance = 1e-6;
    double       energy_tolerance   = 1e-10;
    bool         line_search        = false;

    void add_parameters(dealii::ParameterHandler &prm);
  };

  /// What one increment cost and how it went.
  struct NewtonReport
  {
    bool                      converged  = false;
    unsigned int              iterations = 0;
    std::vector<double>       residuals; ///< |R| / scale, one per assembly
    std::vector<unsigned int> state_changes;
    std::string               reason; ///< why not, in words
  };

  /// Solves R(u) = 0 from the trial of the weak form. An increment has
  /// converged when the unbalanced force is below `residual tolerance` times
  /// the largest of bulk, interface and inertia forces (at least 1e-4 of their
  /// maximum over the run; plus what round-off leaves, 1e-14 |K| |u|, theory
  /// D.4) and the work of the last correction is below `energy tolerance`
  /// times that of the largest one; a tenth of the residual tolerance alone
  /// will do.
  class Newton
  {
  public:
    Newton(const NewtonParameters &parameters, LinearSolver &linear_solver);

    NewtonReport solve(WeakForm &weak_form);

    /// Seconds spent in assembly, all increments.
    double seconds_assembly = 0.;

    /// Largest force norm [N] of a converged increment; part of a checkpoint.
    double largest_force = 0.;

  private:
    bool   assemble(WeakForm &, bool tangent, NewtonReport &);
    bool   has_converged(const NewtonReport &) const;
    double forcing_term(const NewtonReport &report) const;
    void   search_line(WeakForm &, const Vector &du, NewtonReport &);

    const NewtonParameters parameters;
    LinearSolver &         linear_solver;
    double                 round_off    = 0.; ///< [N]
    double                 largest_work = 0.; ///< of a correction [mJ]
    double                 last_work    = 0.;
    Vector                 correction;
    unsigned int           pattern_number = 0;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Differential-algebraic equations with controlled error, by SUNDIALS IDA.
#ifndef demold_rig_dae_solver_h
#define demold_rig_dae_solver_h

#include <functional>
#include <memory>
#include <vector>

namespace demold
{
  /// f(t, y, y') = 0 of index 1.
  struct DaeProblem
  {
    /// Writes f(t, y, y') to the last argument. A false return asks for a
    /// shorter step: f means nothing there.
    std::function<bool(double, const double *, const double *, double *)>
      residual;

    /// Of each unknown: does its derivative appear?
    std::vector<bool> differential;

    double relative_tolerance = 1e-10; ///< of the error of a step
    double absolute_tolerance = 1e-12;
  };

  /// Backward differences of variable order 1 to 5 and variable step.
  class DaeSolver
  {
  public:
    /// @p initial holds the differential unknowns and a guess of the others at
    /// time 0, @p next a time on the scale of the first steps.
    DaeSolver(const DaeProblem          &problem,
              const std::vector<double> &initial,
              double                     next);
    ~DaeSolver();

    /// Goes to time @p t; steps do not look beyond @p limit >= t, where f may
    /// have a corner. Throws std::runtime_error where the tolerances cannot be
    /// kept.
    void advance(double t, double limit);

    /// Starts anew behind a corner of f; @p next as for the constructor.
    void restart(double next);

    const std::vector<double> &state() const;
    long                       n_steps() const; ///< so far

  private:
    struct Ida;
    std::unique_ptr<Ida> ida;
  };
} // namespace demold

#endif

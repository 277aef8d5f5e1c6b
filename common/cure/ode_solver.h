// SPDX-License-Identifier: LGPL-2.1-or-later
// Ordinary differential equations with controlled error, by SUNDIALS ARKODE.
#ifndef demold_cure_ode_solver_h
#define demold_cure_ode_solver_h

#include <functional>
#include <memory>
#include <vector>

namespace demold
{
  /// y' = f(t, y). The functions may throw: solving then ends with their
  /// exception.
  struct OdeProblem
  {
    /// Writes f(t, y) to the last argument.
    std::function<void(double, const double *, double *)> rate;

    /// For stiff problems that are linear in y: writes (df/dy) v for a time t
    /// and a vector v. Empty: explicit steps.
    std::function<void(double, const double *, double *)> jacobian_times;

    /// Solving stops where this passes through zero. Empty: never.
    std::function<double(double, const double *)> event;
  };

  /// The error of a step, weighted by relative |y| + absolute.
  struct OdeTolerances
  {
    double relative = 1e-8;
    double absolute = 1e-10;
  };

  /// Runge-Kutta steps of ARKODE with error control: order 5, explicit; or
  /// order 4, diagonally implicit and L-stable, with BiCGStab, where
  /// jacobian_times is given.
  class OdeSolver
  {
  public:
    OdeSolver(const OdeProblem          &problem,
              const double               start,
              const std::vector<double> &initial,
              const OdeTolerances       &tolerances);
    ~OdeSolver();

    /// Goes to time @p t [s], or to the event if that comes first; then returns
    /// true. Steps do not look beyond @p limit >= t, where f may jump; between
    /// steps the state is interpolated to their order.
    bool advance(const double t, const double limit);

    /// One step, which ends at @p limit or before it.
    void step(const double limit);

    double                     time() const;
    const std::vector<double> &state() const;

  private:
    struct Arkode;
    std::unique_ptr<Arkode> arkode;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// The equation that a path has more than its unknowns.
#ifndef demold_solution_path_constraint_h
#define demold_solution_path_constraint_h

#include "weak_form/algebra.h"

#include <string>

namespace demold
{
  class WeakForm;
  struct SofteningSite;

  /// c(u, t) = 0 with a gradient: how far one step goes along the path. What
  /// depends on the time through supports and mould the corrector finds by
  /// differences. All calls are collective.
  class PathConstraint
  {
  public:
    virtual ~PathConstraint() = default;

    /// Word of the parameter file.
    virtual std::string name() const = 0;

    /// Begins a step of @p size, times what the constraint thinks a full step
    /// is. The trial is the accepted state, the driven points are known.
    virtual void start(const WeakForm &weak_form, const double size) = 0;

    /// c, in the unit of tolerance(), at the trial in Newton iteration
    /// @p iteration; iteration 0 is the predictor.
    virtual double value(const WeakForm    &weak_form,
                         const unsigned int iteration) const = 0;

    /// Adds dc/du to @p h, which is zero.
    virtual void add_gradient(const WeakForm    &weak_form,
                              const unsigned int iteration,
                              Vector            &h) const = 0;

    /// |c| of a converged step.
    virtual double tolerance() const = 0;

    /// The step will be accepted; called before it is.
    virtual void accepted(const WeakForm &)
    {}
  };
} // namespace demold

#endif

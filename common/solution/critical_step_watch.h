// SPDX-License-Identifier: LGPL-2.1-or-later
// When the critical step of a long explicit run is found anew.
#ifndef demold_solution_critical_step_watch_h
#define demold_solution_critical_step_watch_h

#include "weak_form/algebra.h"

#include <vector>

namespace demold
{
  class WeakForm;

  /// Finds the critical step after every 1000 steps, and at once where points
  /// have changed their state, as contact may be stiffer than the rubber: so
  /// many times in a row, then once in 50 steps. Chattering points would make
  /// the step jump up and down: what is found where they change may only lower
  /// it.
  class CriticalStepWatch
  {
  public:
    /// @param mass lumped mass [t]; both arguments must live as long.
    CriticalStepWatch(WeakForm &weak_form, const Vector &mass);

    /// Before a step: finds the critical one if that is due. @p dt [s] for the
    /// tangent, see critical_step(). Was it due?
    bool look(const double dt);

    /// After a step: have points changed their state in it, on any rank?
    void count(const bool states_changed);

    /// [s], 0 before the first look.
    double critical() const
    {
      return step;
    }

    /// State for checkpoints.
    std::vector<double> save() const;
    void                load(const std::vector<double> &values);

  private:
    WeakForm     &weak_form;
    const Vector &mass;
    double        step = 0.;       ///< [s]
    double        age  = 0.;       ///< steps since it could last grow
    double        credit;          ///< looks that may still be taken at once
    bool          changed = false; ///< states, since the last look
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// When the critical step of a long explicit run is found anew.
#include "solution/critical_step_watch.h"

#include "solution/critical_step.h"

#include <algorithm>

namespace demold
{
  namespace
  {
    /// Steps after which the critical one is found in any case.
    constexpr double longest_trust = 1000.;

    /// Looks at changed states in a row, and steps that pay for one more.
    constexpr double most_credit = 20., steps_per_credit = 50.;
  } // namespace

  CriticalStepWatch::CriticalStepWatch(WeakForm &weak_form, const Vector &mass)
    : weak_form(weak_form)
    , mass(mass)
    , credit(most_credit)
  {}

  bool CriticalStepWatch::look(const double dt)
  {
    if (step == 0. || age >= longest_trust)
      {
        step = critical_step(weak_form, mass, dt);
        age  = 0.;
      }
    else if (changed && credit >= 1.)
      {
        step = std::min(step, critical_step(weak_form, mass, dt));
        credit -= 1.;
      }
    else
      return false;
    changed = false;
    return true;
  }

  void CriticalStepWatch::count(const bool states_changed)
  {
    changed = changed || states_changed;
    age += 1.;
    credit = std::min(most_credit, credit + 1. / steps_per_credit);
  }

  std::vector<double> CriticalStepWatch::save() const
  {
    return {step, age, credit, changed ? 1. : 0.};
  }

  void CriticalStepWatch::load(const std::vector<double> &values)
  {
    step    = values.at(0);
    age     = values.at(1);
    credit  = values.at(2);
    changed = values.at(3) > 0.;
  }
} // namespace demold

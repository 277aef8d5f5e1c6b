// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a path runs back behind the clock, and what a machine would miss there.
#include "solution/excursion.h"

#include "solution/softening_overview.h"
#include "weak_form/dead_load.h"
#include "weak_form/weak_form.h"

namespace demold
{
  namespace
  {
    /// Dead loads of @p time times the displacements of the trial [mJ].
    double potential(const WeakForm &weak_form, const double time)
    {
      double sum = 0.;
      for (const auto &term : weak_form.term_list())
        if (const auto *load = dynamic_cast<const DeadLoad *>(term.get()))
          sum += load->potential(time);
      return sum_over_ranks(weak_form, sum);
    }
  } // namespace

  void Excursion::begin(const WeakForm &weak_form)
  {
    last_external = weak_form.energies().external;
  }

  void Excursion::look(const WeakForm &weak_form)
  {
    const double external = weak_form.energies().external;
    const double done     = external - last_external;
    const double from     = weak_form.time();
    const double to       = weak_form.trial_time();
    const double clock    = weak_form.clock();
    last_external         = external;
    released              = 0.;
    kind                  = "envelope";
    if (to < clock - 1e-12 * std::abs(clock))
      {
        inside = true;
        work += done;
        kind = "static path";
        return;
      }
    if (inside)
      {
        const double part = to > from ? (clock - from) / (to - from) : 1.;
        released = potential(weak_form, clock) - at_turn - (work + part * done);
        kind     = "jump";
      }
    inside  = false;
    work    = 0.;
    at_turn = potential(weak_form, to);
  }

  std::vector<double> Excursion::save() const
  {
    return {inside ? 1. : 0., work, at_turn, last_external};
  }

  void Excursion::load(const std::vector<double> &values)
  {
    inside        = values.at(0) > 0.;
    work          = values.at(1);
    at_turn       = values.at(2);
    last_external = values.at(3);
  }
} // namespace demold

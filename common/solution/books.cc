// SPDX-License-Identifier: LGPL-2.1-or-later
// The ledger as a judge of increments without inertia.
#include "solution/books.h"

#include "weak_form/weak_form.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  namespace
  {
    /// Share of the largest ledger entry.
    constexpr double tolerated_gap = 2e-3;

    double largest_of(const Energies &energies, double largest)
    {
      for (const double entry : energies.as_array())
        largest = std::max(largest, std::abs(entry));
      return largest;
    }
  } // namespace

  Books::Books(const WeakForm &weak_form)
    : accepted(weak_form.energies())
    , trial(accepted)
  {}

  double Books::unexplained_share() const
  {
    return std::abs(trial.gap() - accepted.gap()) /
           std::max(largest_of(trial, largest_entry), 1e-300);
  }

  bool Books::are_open() const
  {
    return unexplained_share() > tolerated_gap;
  }

  double Books::tolerated() const
  {
    return tolerated_gap * largest_of(accepted, largest_entry);
  }

  bool Books::loses() const
  {
    return trial.gap() > accepted.gap();
  }

  void Books::accept()
  {
    accepted      = trial;
    largest_entry = largest_of(trial, largest_entry);
  }
} // namespace demold

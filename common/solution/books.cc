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
  } // namespace

  Books::Books(const WeakForm &weak_form)
    : accepted(weak_form.energies())
    , trial(accepted)
  {}

  double Books::unexplained_share() const
  {
    double largest = largest_entry;
    for (const double entry : trial.as_array())
      largest = std::max(largest, std::abs(entry));
    return std::abs(trial.gap() - accepted.gap()) / std::max(largest, 1e-300);
  }

  bool Books::are_open() const
  {
    return unexplained_share() > tolerated_gap;
  }

  bool Books::loses() const
  {
    return trial.gap() > accepted.gap();
  }

  void Books::accept()
  {
    accepted = trial;
    for (const double entry : trial.as_array())
      largest_entry = std::max(largest_entry, std::abs(entry));
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// The ledger as a judge of increments without inertia.
#ifndef demold_solution_books_h
#define demold_solution_books_h

#include "weak_form/energies.h"

namespace demold
{
  class WeakForm;

  /// Ledger at the last accepted time and of the increment under judgement.
  struct Books
  {
    /// Opens them at the accepted state of @p weak_form.
    explicit Books(const WeakForm &weak_form);

    /// Of the trial increment, over the largest entry so far.
    double unexplained_share() const;

    /// Does the trial increment leave more unexplained than kinks in the forces
    /// do, as external work is known by the trapezoidal rule only?
    bool are_open() const;

    /// [mJ] that the next increment may leave unexplained at least.
    double tolerated() const;

    /// Does the trial increment lose energy rather than gain it?
    bool loses() const;

    void accept();

    Energies accepted, trial;
    double   largest_entry = 0.; ///< [mJ]
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// What the rubber of a cell shows in pictures: stress, stretch, cure.
#ifndef demold_solid_cell_results_h
#define demold_solid_cell_results_h

#include "solid/voigt.h"

#include <vector>

namespace demold
{
  /// One cell in the accepted state. Means are over its quadrature points.
  struct CellResult
  {
    unsigned int index; ///< of the active cell

    /// Cauchy stress, mean over the current volume [MPa], in the order 11, 22,
    /// 33, 12, 13, 23. With mean dilatation it is the effective stress, whose
    /// mean is the same.
    Voigt stress;

    /// Largest principal value of that mean [MPa], tension positive.
    double largest_tension;

    /// Root of the largest eigenvalue of the mean of C = F^T F, with the F
    /// that the law sees [-].
    double largest_stretch;

    double f90; ///< state of cure at the centre [-]
  };

  /// A term that can tell what its cells look like.
  class CellResults
  {
  public:
    virtual ~CellResults() = default;

    /// The cells of this rank that belong to the term.
    virtual std::vector<CellResult> cell_results() const = 0;
  };
} // namespace demold

#endif

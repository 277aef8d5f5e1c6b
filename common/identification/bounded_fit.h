// SPDX-License-Identifier: LGPL-2.1-or-later
// Nonlinear least squares between bounds, by Trilinos' ROL.
#ifndef demold_identification_bounded_fit_h
#define demold_identification_bounded_fit_h

#include "identification/fit_problem.h"

#include <vector>

namespace demold
{
  /// Where the search has ended.
  struct FitResult
  {
    std::vector<double> parameters;
    unsigned int        n_iterations = 0; ///< of the trust region

    /// Largest correlation of r with a column of J that may still move [-]:
    /// |J_j . r|/(|J_j| |r|); zero at a minimum.
    double slope = 0.;
  };

  /// The trust region of Lin and More (1999) on the Gauss-Newton model, in
  /// parameters scaled by the columns of J; then Gauss-Newton steps of the free
  /// parameters by singular values, which reach round-off where the data are
  /// matched exactly. A local minimum: the start matters.
  FitResult minimise(const FitProblem &problem);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Nonlinear least squares between bounds, by Trilinos' ROL.
#ifndef demold_identification_bounded_fit_h
#define demold_identification_bounded_fit_h

#include <deal.II/lac/full_matrix.h>

#include <functional>
#include <vector>

namespace demold
{
  /// min 1/2 |r(q)|^2 with lower <= q <= upper. Bounds may be infinite.
  struct FitProblem
  {
    using Vector = std::vector<double>;

    unsigned int                                              n_residuals = 0;
    std::function<Vector(const Vector &)>                     residuals;
    std::function<dealii::FullMatrix<double>(const Vector &)> jacobian;
    Vector                                                    start;
    Vector                                                    lower, upper;

    /// The search ends where the gradient has fallen by this factor [-]; not
    /// below what the accuracy of the residuals allows.
    double tolerance = 1e-10;
  };

  /// Where the search has ended.
  struct FitResult
  {
    std::vector<double> parameters;
    unsigned int        n_iterations = 0; ///< of the trust region

    /// Largest correlation of r with a column of J that may still move [-]:
    /// |J_j . r|/(|J_j| |r|); zero at a minimum.
    double slope = 0.;
  };

  /// dr/dq by central differences with relative steps @p step, for problems
  /// without a closed form; steps do not leave the bounds.
  dealii::FullMatrix<double>
  jacobian_by_differences(const FitProblem          &problem,
                          const std::vector<double> &q,
                          double                     step = 1e-6);

  /// The trust region of Lin and More (1999) on the Gauss-Newton model, in
  /// parameters scaled by the columns of J; then Gauss-Newton steps of the free
  /// parameters by singular values, which reach round-off where the data are
  /// matched exactly. A local minimum: the start matters.
  FitResult minimise(const FitProblem &problem);
} // namespace demold

#endif

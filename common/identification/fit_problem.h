// SPDX-License-Identifier: LGPL-2.1-or-later
// A least-squares problem between bounds, and what its parts amount to.
#ifndef demold_identification_fit_problem_h
#define demold_identification_fit_problem_h

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

    /// @p q where it is within the bounds, the bound where it is beyond.
    Vector clipped(Vector q) const;
  };

  double half_square(const std::vector<double> &r); ///< 1/2 |r|^2

  /// J^T r, the gradient of half_square().
  std::vector<double> transposed_product(const dealii::FullMatrix<double> &J,
                                         const std::vector<double>        &r);

  /// How much each parameter moves the residuals: the lengths of the columns.
  std::vector<double> column_lengths(const dealii::FullMatrix<double> &J);

  /// dr/dq by central differences with relative steps @p step, for problems
  /// without a closed form; steps do not leave the bounds.
  dealii::FullMatrix<double>
  jacobian_by_differences(const FitProblem          &problem,
                          const std::vector<double> &q,
                          double                     step = 1e-6);
} // namespace demold

#endif

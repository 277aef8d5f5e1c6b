// SPDX-License-Identifier: LGPL-2.1-or-later
// Linear least squares by singular values, without and with x >= 0.
#ifndef demold_identification_least_squares_h
#define demold_identification_least_squares_h

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace demold
{
  /// Singular values of a matrix of m >= n rows, its columns scaled to length
  /// one before: so all results are independent of the parameters' units.
  class ScaledSvd
  {
  public:
    /// @p A: m x n, n > 0; columns of zeros are allowed and have rank 0.
    explicit ScaledSvd(const dealii::FullMatrix<double> &A);

    /// The shortest x of smallest |A x - b|; directions whose singular value is
    /// below 1e-13 of the largest are left out.
    std::vector<double> solve(const std::vector<double> &b) const;

    /// (A^T A)^-1, n x n; infinite where A has not full rank.
    dealii::FullMatrix<double> inverse_normal_matrix() const;

    /// Largest over smallest singular value [-]; infinite without full rank.
    double condition() const;

  private:
    std::vector<double>        length; // of the columns
    std::vector<double>        sigma;
    dealii::FullMatrix<double> U, Vt;
  };

  /// The x >= 0 of smallest |A x - b|, @p A: m x n, m >= n. The optimiser
  /// (bounded_fit.h) finds which entries vanish; the linear problem of the
  /// others is then solved directly, so that exact data give the exact x, and
  /// the conditions of Karush, Kuhn and Tucker are established as Lawson and
  /// Hanson (1974) do.
  std::vector<double>
  nonnegative_least_squares(const dealii::FullMatrix<double> &A,
                            const std::vector<double>        &b);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Conjugate gradients and GMRES that report instead of throwing.
#ifndef demold_solution_krylov_h
#define demold_solution_krylov_h

#include "weak_form/algebra.h"

#include <functional>
#include <vector>

namespace demold
{
  /// y = approximately A^-1 x
  struct Preconditioner
  {
    std::function<void(Vector &y, const Vector &x)> vmult;
  };

  /// How a Krylov method ended.
  struct KrylovReport
  {
    enum class End
    {
      converged,
      iterations_exceeded,
      breakdown ///< negative curvature (CG), or not a number
    };
    End          end        = End::converged;
    unsigned int iterations = 0;

    /// |b - A x| / |b| before the first iteration and after each.
    std::vector<double> residuals;
  };

  /// Both start from x = 0 and stop once |b - A x| <= @p tolerance |b|.
  struct KrylovLimits
  {
    double       tolerance      = 1e-8; ///< [-]
    unsigned int max_iterations = 200;
  };

  /// Symmetric positive definite A and preconditioner; stops at the first
  /// direction of negative curvature of either.
  KrylovReport conjugate_gradients(const SparseMatrix   &A,
                                   Vector               &x,
                                   const Vector         &b,
                                   const Preconditioner &preconditioner,
                                   const KrylovLimits   &limits);

  /// Any A; preconditioned from the right, restarted after 60 iterations.
  KrylovReport gmres(const SparseMatrix   &A,
                     Vector               &x,
                     const Vector         &b,
                     const Preconditioner &preconditioner,
                     const KrylovLimits   &limits);
} // namespace demold

#endif

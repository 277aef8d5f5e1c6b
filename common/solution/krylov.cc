// SPDX-License-Identifier: LGPL-2.1-or-later
// Conjugate gradients and GMRES that report instead of throwing.
#include "solution/krylov.h"

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    struct NegativeCurvature
    {};

    /// Runs @p solve and turns what it throws into a report.
    KrylovReport report_on(const std::function<void(SolverControl &)> &solve,
                           const Vector                               &b,
                           const KrylovLimits                         &limits)
    {
      const double  norm = b.l2_norm();
      SolverControl control(limits.max_iterations,
                            limits.tolerance * norm,
                            false,
                            false);
      control.enable_history_data();
      KrylovReport report;
      try
        {
          solve(control);
        }
      catch (const NegativeCurvature &)
        {
          report.end = KrylovReport::End::breakdown;
        }
      catch (const SolverControl::NoConvergence &failure)
        {
          report.end = std::isfinite(failure.last_residual) ?
                         KrylovReport::End::iterations_exceeded :
                         KrylovReport::End::breakdown;
        }
      if (control.last_step() != numbers::invalid_unsigned_int)
        report.iterations = control.last_step();
      report.residuals = control.get_history_data();
      for (double &residual : report.residuals)
        residual /= norm;
      return report;
    }
  } // namespace


  KrylovReport conjugate_gradients(const SparseMatrix   &A,
                                   Vector               &x,
                                   const Vector         &b,
                                   const Preconditioner &preconditioner,
                                   const KrylovLimits   &limits)
  {
    x = 0.;
    return report_on(
      [&](SolverControl &control) {
        SolverCG<Vector> solver(control);
        // alpha is the ratio of the curvatures of preconditioner and matrix.
        solver.connect_coefficients_slot([](const double alpha, double) {
          if (!(alpha > 0.) || !std::isfinite(alpha))
            throw NegativeCurvature();
        });
        solver.solve(A, x, b, preconditioner);
      },
      b,
      limits);
  }


  KrylovReport gmres(const SparseMatrix   &A,
                     Vector               &x,
                     const Vector         &b,
                     const Preconditioner &preconditioner,
                     const KrylovLimits   &limits)
  {
    x = 0.;
    SolverGMRES<Vector>::AdditionalData data;
    data.max_n_tmp_vectors     = 62;
    data.right_preconditioning = true;
    return report_on(
      [&](SolverControl &control) {
        SolverGMRES<Vector>(control, data).solve(A, x, b, preconditioner);
      },
      b,
      limits);
  }
} // namespace demold

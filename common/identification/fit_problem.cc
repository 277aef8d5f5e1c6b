// SPDX-License-Identifier: LGPL-2.1-or-later
// A least-squares problem between bounds, and what its parts amount to.
#include "identification/fit_problem.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  std::vector<double> FitProblem::clipped(Vector q) const
  {
    for (unsigned int j = 0; j < q.size(); ++j)
      q[j] = std::min(std::max(q[j], lower[j]), upper[j]);
    return q;
  }



  double half_square(const std::vector<double> &r)
  {
    double sum = 0.;
    for (const double v : r)
      sum += v * v;
    return .5 * sum;
  }



  std::vector<double> transposed_product(const FullMatrix<double>  &J,
                                         const std::vector<double> &r)
  {
    std::vector<double> g(J.n(), 0.);
    for (unsigned int i = 0; i < J.m(); ++i)
      for (unsigned int j = 0; j < J.n(); ++j)
        g[j] += J(i, j) * r[i];
    return g;
  }



  std::vector<double> column_lengths(const FullMatrix<double> &J)
  {
    std::vector<double> length(J.n(), 0.);
    for (unsigned int i = 0; i < J.m(); ++i)
      for (unsigned int j = 0; j < J.n(); ++j)
        length[j] = std::hypot(length[j], J(i, j));
    return length;
  }



  FullMatrix<double> jacobian_by_differences(const FitProblem          &problem,
                                             const std::vector<double> &q,
                                             const double               step)
  {
    FullMatrix<double> J(problem.n_residuals, q.size());
    for (unsigned int j = 0; j < q.size(); ++j)
      {
        const double        h  = step * std::max(std::abs(q[j]), 1e-3);
        std::vector<double> up = q, down = q;
        up[j]                        = std::min(q[j] + h, problem.upper[j]);
        down[j]                      = std::max(q[j] - h, problem.lower[j]);
        const std::vector<double> r1 = problem.residuals(up),
                                  r0 = problem.residuals(down);
        for (unsigned int i = 0; i < J.m(); ++i)
          J(i, j) = (r1[i] - r0[i]) / (up[j] - down[j]);
      }
    return J;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Linear least squares by singular values, without and with x >= 0.
#include "identification/least_squares.h"

#include "identification/bounded_fit.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr double rank_tolerance = 1e-13;

    FullMatrix<double> full(const LAPACKFullMatrix<double> &matrix)
    {
      FullMatrix<double> result(matrix.m(), matrix.n());
      for (unsigned int i = 0; i < matrix.m(); ++i)
        for (unsigned int j = 0; j < matrix.n(); ++j)
          result(i, j) = matrix(i, j);
      return result;
    }



    FullMatrix<double> columns_of(const FullMatrix<double>        &A,
                                  const std::vector<unsigned int> &which)
    {
      FullMatrix<double> result(A.m(), which.size());
      for (unsigned int i = 0; i < A.m(); ++i)
        for (unsigned int j = 0; j < which.size(); ++j)
          result(i, j) = A(i, which[j]);
      return result;
    }



    std::vector<double> difference(const FullMatrix<double>  &A,
                                   const std::vector<double> &x,
                                   const std::vector<double> &b)
    {
      std::vector<double> r(b.size());
      for (unsigned int i = 0; i < A.m(); ++i)
        {
          r[i] = -b[i];
          for (unsigned int j = 0; j < A.n(); ++j)
            r[i] += A(i, j) * x[j];
        }
      return r;
    }



    std::vector<unsigned int> positive_entries(const std::vector<double> &x)
    {
      std::vector<unsigned int> free;
      for (unsigned int j = 0; j < x.size(); ++j)
        if (x[j] > 0.)
          free.push_back(j);
      return free;
    }



    /// Solves for the positive entries of @p x alone. Where one of them would
    /// become negative, goes as far as the first that vanishes, and again.
    void solve_for_positive(const FullMatrix<double>  &A,
                            const std::vector<double> &b,
                            std::vector<double>       &x)
    {
      while (true)
        {
          const auto free = positive_entries(x);
          if (free.empty())
            return;
          const auto   target = ScaledSvd(columns_of(A, free)).solve(b);
          double       step   = 1.;
          unsigned int first  = 0;
          for (unsigned int k = 0; k < free.size(); ++k)
            if (target[k] <= 0.)
              {
                const double to_zero = x[free[k]] / (x[free[k]] - target[k]);
                if (to_zero <= step)
                  {
                    step  = to_zero;
                    first = free[k];
                  }
              }
          bool vanished = false;
          for (unsigned int k = 0; k < free.size(); ++k)
            {
              x[free[k]] += step * (target[k] - x[free[k]]);
              if (target[k] <= 0. && (free[k] == first || x[free[k]] <= 0.))
                {
                  x[free[k]] = 0.;
                  vanished   = true;
                }
            }
          if (!vanished)
            return;
        }
    }



    /// What |A x - b| gains, relative, by an entry that is zero now; the index
    /// of the best, or A.n() if none gains beyond round-off.
    unsigned int best_new_entry(const FullMatrix<double>  &A,
                                const std::vector<double> &x,
                                const std::vector<double> &b)
    {
      const auto   r    = difference(A, x, b);
      double       best = 0., size = 0.;
      unsigned int entry = A.n();
      for (const double v : b)
        size += v * v;
      for (unsigned int j = 0; j < A.n(); ++j)
        {
          double gain = 0., square = 0.;
          for (unsigned int i = 0; i < A.m(); ++i)
            {
              gain -= A(i, j) * r[i];
              square += A(i, j) * A(i, j);
            }
          gain /= std::sqrt(square * size) + 1e-300;
          if (x[j] == 0. && gain > std::max(best, 1e-13))
            {
              best  = gain;
              entry = j;
            }
        }
      return entry;
    }



    /// The optimiser's answer to min |A x - b|, x >= 0, with what is near zero
    /// set to zero.
    std::vector<double> optimised_start(const FullMatrix<double>  &A,
                                        const std::vector<double> &b)
    {
      FitProblem problem;
      problem.n_residuals = A.m();
      problem.start       = ScaledSvd(A).solve(b);
      problem.lower.assign(A.n(), 0.);
      problem.upper.assign(A.n(), std::numeric_limits<double>::infinity());
      problem.residuals = [&](const std::vector<double> &x) {
        return difference(A, x, b);
      };
      problem.jacobian = [&](const std::vector<double> &) { return A; };

      auto   x       = minimise(problem).parameters;
      double largest = 0.;
      for (const double v : x)
        largest = std::max(largest, v);
      for (double &v : x)
        if (v < 1e-7 * largest)
          v = 0.;
      return x;
    }
  } // namespace



  ScaledSvd::ScaledSvd(const FullMatrix<double> &A)
    : length(A.n(), 0.)
    , sigma(A.n())
  {
    AssertThrow(A.m() >= A.n() && A.n() > 0,
                ExcMessage("fewer data than parameters"));
    LAPACKFullMatrix<double> scaled(A.m(), A.n());
    for (unsigned int j = 0; j < A.n(); ++j)
      {
        for (unsigned int i = 0; i < A.m(); ++i)
          length[j] = std::hypot(length[j], A(i, j));
        if (length[j] == 0.)
          length[j] = 1.;
        for (unsigned int i = 0; i < A.m(); ++i)
          scaled(i, j) = A(i, j) / length[j];
      }
    scaled.compute_svd();
    for (unsigned int j = 0; j < A.n(); ++j)
      sigma[j] = scaled.singular_value(j);
    U  = full(scaled.get_svd_u());
    Vt = full(scaled.get_svd_vt());
  }



  std::vector<double> ScaledSvd::solve(const std::vector<double> &b) const
  {
    std::vector<double> x(sigma.size(), 0.);
    for (unsigned int k = 0; k < sigma.size(); ++k)
      if (sigma[k] > rank_tolerance * sigma[0])
        {
          double along = 0.;
          for (unsigned int i = 0; i < b.size(); ++i)
            along += U(i, k) * b[i];
          for (unsigned int j = 0; j < x.size(); ++j)
            x[j] += Vt(k, j) * along / sigma[k];
        }
    for (unsigned int j = 0; j < x.size(); ++j)
      x[j] /= length[j];
    return x;
  }



  FullMatrix<double> ScaledSvd::inverse_normal_matrix() const
  {
    const unsigned int n        = sigma.size();
    const double       infinity = std::numeric_limits<double>::infinity();
    FullMatrix<double> result(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        {
          for (unsigned int k = 0; k < n; ++k)
            result(i, j) += Vt(k, i) * Vt(k, j) / (sigma[k] * sigma[k]) /
                            (length[i] * length[j]);
          if (std::isinf(condition()))
            result(i, j) = infinity;
        }
    return result;
  }



  double ScaledSvd::condition() const
  {
    return sigma.back() > rank_tolerance * sigma[0] ?
             sigma[0] / sigma.back() :
             std::numeric_limits<double>::infinity();
  }



  std::vector<double> nonnegative_least_squares(const FullMatrix<double>  &A,
                                                const std::vector<double> &b)
  {
    std::vector<double> x = optimised_start(A, b);
    // Every pass lowers |A x - b|, so that no set of positive entries returns.
    for (unsigned int pass = 0; pass < 10 * A.n(); ++pass)
      {
        solve_for_positive(A, b, x);
        const unsigned int entry = best_new_entry(A, x, b);
        if (entry == A.n())
          break;
        x[entry] = std::numeric_limits<double>::min();
      }
    return x;
  }
} // namespace demold

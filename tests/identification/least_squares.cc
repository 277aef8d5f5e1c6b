// SPDX-License-Identifier: LGPL-2.1-or-later
// Bounded least squares find the minimum that its conditions characterise.
#include "identification/least_squares.h"

#include "identification/bounded_fit.h"
#include "identification/fit_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{
  using namespace demold;
  using dealii::FullMatrix;

  constexpr double infinity = std::numeric_limits<double>::infinity();

  FullMatrix<double> random_matrix(const unsigned int m,
                                   const unsigned int n,
                                   std::mt19937      &generator)
  {
    std::uniform_real_distribution<double> number(-.3, 1.);
    FullMatrix<double>                     A(m, n);
    for (unsigned int i = 0; i < m; ++i)
      for (unsigned int j = 0; j < n; ++j)
        A(i, j) = number(generator);
    return A;
  }

  TEST(nonnegative_least_squares, fulfil_the_conditions_of_kuhn_and_tucker)
  {
    std::mt19937                     generator(7);
    std::normal_distribution<double> number;
    unsigned int                     n_zeros = 0;
    for (unsigned int run = 0; run < 50; ++run)
      {
        const auto          A = random_matrix(20, 8, generator);
        std::vector<double> b(20);
        for (double &v : b)
          v = number(generator);
        const auto x = nonnegative_least_squares(A, b);
        for (unsigned int j = 0; j < 8; ++j)
          {
            double slope = 0.;
            for (unsigned int i = 0; i < 20; ++i)
              {
                double r = -b[i];
                for (unsigned int k = 0; k < 8; ++k)
                  r += A(i, k) * x[k];
                slope += A(i, j) * r;
              }
            n_zeros += x[j] == 0. ? 1 : 0;
            EXPECT_GE(x[j], 0.);
            EXPECT_GE(slope, -1e-11);
            EXPECT_LE(slope * x[j], 1e-11);
          }
      }
    EXPECT_GT(n_zeros, 50u); // the bounds did matter
  }

  TEST(bounded_fit, finds_the_minimum_of_rosenbrock_and_stops_at_a_bound)
  {
    FitProblem problem;
    problem.n_residuals = 2;
    problem.residuals   = [](const std::vector<double> &q) {
      return std::vector<double>{10. * (q[1] - q[0] * q[0]), 1. - q[0]};
    };
    problem.jacobian = [](const std::vector<double> &q) {
      FullMatrix<double> J(2, 2);
      J(0, 0) = -20. * q[0];
      J(0, 1) = 10.;
      J(1, 0) = -1.;
      return J;
    };
    problem.start = {-1.2, 1.};
    problem.lower = {-infinity, -infinity};
    problem.upper = {infinity, infinity};
    auto q        = minimise(problem).parameters;
    EXPECT_NEAR(q[0], 1., 1e-12);
    EXPECT_NEAR(q[1], 1., 1e-12);

    // With q0 <= 1/2 the other follows: q1 = q0^2.
    problem.upper = {.5, infinity};
    q             = minimise(problem).parameters;
    EXPECT_NEAR(q[0], .5, 1e-12);
    EXPECT_NEAR(q[1], .25, 1e-10);

    const auto exact = problem.jacobian({.3, .7});
    const auto J     = jacobian_by_differences(problem, {.3, .7});
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
        EXPECT_NEAR(J(i, j), exact(i, j), 1e-8);
  }

  /// A straight line a + b x through noise: closed form of the uncertainties
  /// from the sums of x.
  TEST(fit_report, standard_errors_of_a_line_are_those_of_the_textbook)
  {
    const std::vector<double> x = {0., 1., 2., 3., 5.},
                              y = {1.1, 2.9, 5.2, 6.8, 11.1};
    FullMatrix<double> A(5, 2);
    double             mean = 0., square = 0.;
    for (unsigned int i = 0; i < 5; ++i)
      {
        A(i, 0) = 1.;
        A(i, 1) = x[i];
        mean += x[i] / 5.;
      }
    const auto          q = ScaledSvd(A).solve(y);
    std::vector<double> r;
    double              scatter = 0.;
    for (unsigned int i = 0; i < 5; ++i)
      {
        r.push_back(q[0] + q[1] * x[i] - y[i]);
        square += r.back() * r.back();
        scatter += (x[i] - mean) * (x[i] - mean);
      }
    const auto   report = assess({{"a", "-", q[0], -infinity, infinity},
                                  {"b", "-", q[1], -infinity, infinity}},
                               r,
                               A);
    const double s2     = square / 3.;
    EXPECT_NEAR(report.parameters[1].standard_error,
                std::sqrt(s2 / scatter),
                1e-13);
    EXPECT_NEAR(report.parameters[0].standard_error,
                std::sqrt(s2 * (1. / 5. + mean * mean / scatter)),
                1e-13);
    EXPECT_NEAR(report.correlation(0, 1),
                -mean / std::sqrt(scatter / 5. + mean * mean),
                1e-13);
    EXPECT_EQ(report.identifiability(), "The data identify all parameters.");
  }

  TEST(fit_report, says_when_only_a_combination_is_determined)
  {
    FullMatrix<double> A(3, 2);
    for (unsigned int i = 0; i < 3; ++i)
      A(i, 0) = A(i, 1) = 1. + i;
    const auto report = assess({{"a", "-", 1., -infinity, infinity},
                                {"b", "-", 1., -infinity, infinity}},
                               {.1, -.1, .05},
                               A);
    EXPECT_TRUE(std::isinf(report.condition));
    EXPECT_NE(report.identifiability().find("only combinations"),
              std::string::npos);
  }
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// Orders and the Pareto front agree with errors whose law is known.
#include "study/accuracy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace demold
{
  namespace
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();

    double error_of_order(const double p, const double h)
    {
      return .3 * std::pow(h, p);
    }
  } // namespace

  TEST(ObservedOrder, is_the_exponent_of_the_error)
  {
    for (const double p : {.5, 1., 2., 3.7})
      EXPECT_NEAR(
        observed_order(error_of_order(p, .2), error_of_order(p, .05), .2, .05),
        p,
        1e-12);
  }

  TEST(ObservedOrder, counts_refine_as_sizes_do)
  {
    // n elements of size 1/n.
    EXPECT_NEAR(observed_order(error_of_order(2., 1. / 4),
                               error_of_order(2., 1. / 12),
                               4.,
                               12.),
                2.,
                1e-12);
  }

  TEST(ObservedOrder, is_negative_when_the_error_grows)
  {
    EXPECT_NEAR(observed_order(1., 4., .2, .1), -2., 1e-12);
  }

  TEST(ObservedOrder, is_unknown_without_two_positive_errors_and_sizes)
  {
    EXPECT_TRUE(std::isnan(observed_order(0., 1., .2, .1)));
    EXPECT_TRUE(std::isnan(observed_order(1., nan, .2, .1)));
    EXPECT_TRUE(std::isnan(observed_order(1., .5, .1, .1)));
    EXPECT_TRUE(std::isnan(observed_order(1., .5, nan, .1)));
    EXPECT_TRUE(std::isnan(observed_order(1., .5, -.2, .1)));
  }

  TEST(FittedOrder, is_the_exponent_of_the_error)
  {
    std::vector<double> errors, sizes;
    for (const double h : {.4, .25, .1, .03})
      {
        errors.push_back(error_of_order(1.5, h));
        sizes.push_back(h);
      }
    EXPECT_NEAR(fitted_order(errors, sizes, 1e-12), 1.5, 1e-12);
    for (double &h : sizes)
      h = 1. / h;
    EXPECT_NEAR(fitted_order(errors, sizes, 1e-12), 1.5, 1e-12);
  }

  TEST(FittedOrder, leaves_out_round_off_and_failed_runs)
  {
    const std::vector<double> sizes  = {.4, .2, .1, .05};
    const std::vector<double> errors = {error_of_order(2., .4),
                                        nan,
                                        error_of_order(2., .1),
                                        1e-14};
    EXPECT_NEAR(fitted_order(errors, sizes, 1e-12), 2., 1e-12);
    EXPECT_TRUE(std::isnan(fitted_order({.1, 1e-14}, {.2, .1}, 1e-12)));
  }

  TEST(ParetoFront, holds_what_nothing_beats_in_both)
  {
    const std::vector<double> times  = {1., 2., 3., 4., nan, .5};
    const std::vector<double> errors = {.5, .6, .1, .1, 0., nan};
    // The second is slower and worse than the first, the fourth slower than the
    // third at the same error; the last two have failed.
    EXPECT_EQ(pareto_front(times, errors),
              (std::vector<bool>{true, false, true, false, false, false}));
  }

  TEST(ParetoFront, keeps_equals_side_by_side)
  {
    EXPECT_EQ(pareto_front({1., 1.}, {.1, .1}),
              (std::vector<bool>{true, true}));
  }

  TEST(ParetoFront, agrees_with_a_sweep_over_the_sorted_times)
  {
    std::mt19937                     engine(7);
    std::uniform_real_distribution<> uniform(0., 1.);
    std::vector<double>              times, errors;
    for (unsigned int i = 0; i < 200; ++i)
      {
        times.push_back(uniform(engine));
        errors.push_back(uniform(engine));
      }
    std::vector<std::size_t> order(times.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return times[a] < times[b];
    });
    std::vector<bool> expected(times.size());
    double            best = 2.;
    for (const std::size_t i : order)
      if (errors[i] < best)
        {
          expected[i] = true;
          best        = errors[i];
        }
    EXPECT_EQ(pareto_front(times, errors), expected);
  }
} // namespace demold

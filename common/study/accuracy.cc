// SPDX-License-Identifier: LGPL-2.1-or-later
// What accuracy costs: observed orders and the Pareto front of a set of runs.
#include "study/accuracy.h"

#include <cmath>
#include <limits>

namespace demold
{
  namespace
  {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    bool has_logarithm(const double x)
    {
      return x > 0. && std::isfinite(x);
    }
  } // namespace



  double observed_order(const double coarse_error,
                        const double fine_error,
                        const double coarse,
                        const double fine)
  {
    for (const double x : {coarse_error, fine_error, coarse, fine})
      if (!has_logarithm(x))
        return unknown;
    if (coarse == fine)
      return unknown;
    return std::log(coarse_error / fine_error) /
           std::abs(std::log(coarse / fine));
  }



  double fitted_order(const std::vector<double> &errors,
                      const std::vector<double> &values,
                      const double               round_off)
  {
    std::vector<double> x, y;
    for (std::size_t i = 0; i < errors.size(); ++i)
      if (has_logarithm(errors[i]) && has_logarithm(values[i]) &&
          errors[i] >= round_off)
        {
          x.push_back(std::log(values[i]));
          y.push_back(std::log(errors[i]));
        }
    if (x.size() < 2)
      return unknown;

    double x_mean = 0., y_mean = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        x_mean += x[i] / x.size();
        y_mean += y[i] / x.size();
      }
    double xx = 0., xy = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        xx += (x[i] - x_mean) * (x[i] - x_mean);
        xy += (x[i] - x_mean) * (y[i] - y_mean);
      }
    // A size becomes smaller from coarse to fine, a count larger.
    const double direction = x.back() > x.front() ? -1. : 1.;
    return xx > 0. ? direction * xy / xx : unknown;
  }



  std::vector<bool> pareto_front(const std::vector<double> &times,
                                 const std::vector<double> &errors)
  {
    std::vector<bool> on_front(times.size());
    for (std::size_t i = 0; i < times.size(); ++i)
      {
        on_front[i] = !std::isnan(times[i]) && !std::isnan(errors[i]);
        for (std::size_t k = 0; k < times.size(); ++k)
          if (times[k] <= times[i] && errors[k] <= errors[i] &&
              (times[k] < times[i] || errors[k] < errors[i]))
            on_front[i] = false;
      }
    return on_front;
  }
} // namespace demold

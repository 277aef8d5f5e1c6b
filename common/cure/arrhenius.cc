// SPDX-License-Identifier: LGPL-2.1-or-later
// Rates and times over temperature, and their activation energy from data.
#include "cure/arrhenius.h"

#include <boost/math/distributions/students_t.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace demold
{
  double arrhenius_factor(const double activation_energy,
                          const double temperature,
                          const double reference_temperature)
  {
    return std::exp(
      1e3 * activation_energy / gas_constant *
      (1. / kelvin(reference_temperature) - 1. / kelvin(temperature)));
  }



  double ArrheniusRate::operator()(const double temperature) const
  {
    return reference_value * arrhenius_factor(activation_energy,
                                              temperature,
                                              reference_temperature);
  }



  double ArrheniusTime::operator()(const double temperature) const
  {
    return reference_value / arrhenius_factor(activation_energy,
                                              temperature,
                                              reference_temperature);
  }



  ArrheniusTime
  ArrheniusTime::from_exponential(const double t_0,
                                  const double T_0,
                                  const double reference_temperature)
  {
    return {t_0 * std::exp(T_0 / kelvin(reference_temperature)),
            1e-3 * gas_constant * T_0,
            reference_temperature};
  }



  double ArrheniusFit::prediction_error(const double temperature) const
  {
    const double distance = 1. / kelvin(temperature) - mean_inverse;
    return residual_deviation *
           std::sqrt(1. + 1. / n_points +
                     distance * distance / scatter_inverse);
  }



  ArrheniusFit fit_arrhenius(const std::vector<double> &temperatures,
                             const std::vector<double> &times,
                             const double               reference_temperature)
  {
    const std::size_t n = temperatures.size();
    if (times.size() != n || n < 2)
      throw std::invalid_argument("an activation energy needs a time at each "
                                  "of at least two temperatures");
    double mean_x = 0., mean_y = 0.;
    for (std::size_t i = 0; i < n; ++i)
      {
        if (!(times[i] > 0. && kelvin(temperatures[i]) > 0.))
          throw std::invalid_argument("an activation energy needs positive "
                                      "times and absolute temperatures");
        mean_x += 1. / kelvin(temperatures[i]) / n;
        mean_y += std::log(times[i]) / n;
      }
    double sum_xx = 0., sum_xy = 0.;
    for (std::size_t i = 0; i < n; ++i)
      {
        const double x = 1. / kelvin(temperatures[i]) - mean_x;
        sum_xx += x * x;
        sum_xy += x * (std::log(times[i]) - mean_y);
      }
    // 1e-6: temperatures that differ by less than their digits
    if (!(std::sqrt(sum_xx / n) > 1e-6 * mean_x))
      throw std::invalid_argument("an activation energy needs two different "
                                  "temperatures");
    const double slope = sum_xy / sum_xx;
    double       sum_r = 0.;
    for (std::size_t i = 0; i < n; ++i)
      {
        const double x = 1. / kelvin(temperatures[i]) - mean_x;
        const double r = std::log(times[i]) - mean_y - slope * x;
        sum_r += r * r;
      }

    ArrheniusFit fit;
    fit.n_points           = n;
    fit.law                = {std::exp(mean_y +
                        slope * (1. / kelvin(reference_temperature) - mean_x)),
                              1e-3 * gas_constant * slope,
                              reference_temperature};
    fit.residual_deviation = (n > 2 ? std::sqrt(sum_r / (n - 2)) :
                                      std::numeric_limits<double>::quiet_NaN());
    fit.mean_inverse       = mean_x;
    fit.scatter_inverse    = sum_xx;
    fit.energy_error =
      1e-3 * gas_constant * fit.residual_deviation / std::sqrt(sum_xx);
    return fit;
  }



  double confidence_factor(const double       probability,
                           const unsigned int degrees_of_freedom)
  {
    return boost::math::quantile(boost::math::students_t(
                                   static_cast<double>(degrees_of_freedom)),
                                 .5 + .5 * probability);
  }
} // namespace demold

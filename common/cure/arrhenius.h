// SPDX-License-Identifier: LGPL-2.1-or-later
// Rates and times over temperature, and their activation energy from data.
#ifndef demold_cure_arrhenius_h
#define demold_cure_arrhenius_h

#include <vector>

namespace demold
{
  /// R [J/(mol K)], exact since 2019.
  constexpr double gas_constant = 8.31446261815324;

  /// T [K] of a temperature [degC]. Temperatures are in degC everywhere else.
  inline double kelvin(const double celsius)
  {
    return celsius + 273.15;
  }

  /// exp[E/R (1/T_ref - 1/T)] (theory A11): how much faster than at the
  /// reference temperature [degC]. @p activation_energy [kJ/mol].
  double arrhenius_factor(const double activation_energy,
                          const double temperature,
                          const double reference_temperature);

  /// A rate that grows with temperature: k(T) = k_ref exp[E/R (1/T_ref - 1/T)].
  struct ArrheniusRate
  {
    double reference_value       = 0.;   ///< k_ref [1/s]
    double activation_energy     = 0.;   ///< E [kJ/mol]
    double reference_temperature = 160.; ///< T_ref [degC]

    double operator()(const double temperature) const;
  };

  /// A time that shrinks with temperature: its reciprocal is an ArrheniusRate.
  /// t_0 exp(T_0/T), the induction time of Isayev and Deng, is the same law.
  struct ArrheniusTime
  {
    double reference_value       = 0.;   ///< t_ref [s]
    double activation_energy     = 0.;   ///< E [kJ/mol]
    double reference_temperature = 160.; ///< T_ref [degC]

    double operator()(const double temperature) const;

    /// t_0 [s] exp(T_0 [K]/T) in the form of this struct.
    static ArrheniusTime from_exponential(const double t_0,
                                          const double T_0,
                                          const double reference_temperature);
  };

  /// The straight line ln t = ln t_ref + E/R (1/T - 1/T_ref) through measured
  /// times, such as t90 at several temperatures, by ordinary least squares.
  struct ArrheniusFit
  {
    ArrheniusTime law;
    unsigned int  n_points = 0;
    double        energy_error;       ///< standard error of E [kJ/mol]
    double        residual_deviation; ///< of ln t, n - 2 degrees of freedom [-]
    double        mean_inverse;       ///< mean of 1/T [1/K]
    double        scatter_inverse;    ///< sum of squares about it [1/K^2]

    /// Standard error of ln t for one more curve at @p temperature [degC]:
    /// the error of the line and the scatter of a curve. Near t that is a
    /// relative error [-].
    double prediction_error(const double temperature) const;
  };

  /// @p temperatures [degC] and positive @p times [s], at least two different
  /// temperatures. Two points leave no error to estimate: NaN. Throws
  /// std::invalid_argument for data without a line.
  ArrheniusFit fit_arrhenius(const std::vector<double> &temperatures,
                             const std::vector<double> &times,
                             const double               reference_temperature);

  /// Half the width of the two-sided confidence interval in standard errors:
  /// Student's t for @p probability (0.95) and @p degrees_of_freedom >= 1.
  double confidence_factor(const double       probability,
                           const unsigned int degrees_of_freedom);
} // namespace demold

#endif

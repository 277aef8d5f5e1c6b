// SPDX-License-Identifier: LGPL-2.1-or-later
// From rheometer curves: degree of cure, t_x, activation energy, modulus.
#include "cure/rheometer_curve.h"

#include "cure/arrhenius.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace demold;

namespace
{
  // Milani and Milani, SoftwareX 2016 (GURU v2.0, isothermal_torque_data),
  // thinned: natural rubber and sulphur. The t_x in the tests are those of the
  // 199 measured points.
  RheometerCurve at_140()
  {
    return RheometerCurve(140.,
                          {21.1,
                           151.2,
                           727.8,
                           820.8,
                           858.0,
                           895.2,
                           932.4,
                           969.6,
                           1006.8,
                           1062.6,
                           1137.0,
                           1248.6,
                           1342.2,
                           1491.0,
                           1770.0,
                           2123.4,
                           3165.6,
                           3593.4},
                          {1.082,
                           .856,
                           1.059,
                           1.285,
                           1.726,
                           2.677,
                           3.661,
                           4.521,
                           5.250,
                           6.110,
                           6.894,
                           7.613,
                           8.002,
                           8.424,
                           8.851,
                           9.110,
                           9.263,
                           9.251});
  }

  RheometerCurve at_160()
  {
    return RheometerCurve(160.,
                          {11.3,
                           55.8,
                           146.4,
                           209.4,
                           236.4,
                           254.4,
                           262.8,
                           271.8,
                           281.4,
                           299.4,
                           317.4,
                           353.4,
                           371.4,
                           416.4,
                           488.4,
                           560.4,
                           839.4,
                           1794.0},
                          {1.033,
                           .729,
                           .898,
                           1.163,
                           1.650,
                           2.805,
                           3.514,
                           4.197,
                           4.798,
                           5.730,
                           6.374,
                           7.181,
                           7.463,
                           7.878,
                           8.231,
                           8.459,
                           8.606,
                           8.018});
  }

  RheometerCurve at_170()
  {
    return RheometerCurve(170.,
                          {11.3,
                           29.3,
                           55.8,
                           92.4,
                           119.4,
                           137.4,
                           146.4,
                           155.4,
                           164.4,
                           173.4,
                           182.4,
                           200.4,
                           218.4,
                           245.4,
                           290.4,
                           380.4,
                           1794.0},
                          {.941,
                           .726,
                           .895,
                           1.118,
                           1.543,
                           3.033,
                           4.187,
                           5.145,
                           5.884,
                           6.416,
                           6.796,
                           7.316,
                           7.623,
                           7.924,
                           8.162,
                           8.283,
                           6.772});
  }
} // namespace

TEST(rheometer_curve, gives_the_times_of_the_full_measurement_within_a_percent)
{
  EXPECT_NEAR(at_140().time_of(.5), 997., 10.);
  EXPECT_NEAR(at_140().time_of(.9), 1490., 15.);
  EXPECT_NEAR(at_160().time_of(.1), 232., 2.5);
  EXPECT_NEAR(at_160().time_of(.5), 279., 2.8);
  EXPECT_NEAR(at_160().time_of(.9), 409., 4.);
  EXPECT_NEAR(at_170().time_of(.5), 149., 1.5);
  EXPECT_NEAR(at_170().time_of(.9), 212., 2.1);
}

TEST(rheometer_curve, reports_reversion_as_a_share_of_the_torque_gained)
{
  EXPECT_NEAR(at_140().reversion(), .001, 1e-3);
  EXPECT_NEAR(at_160().reversion(), .075, 1e-3);
  EXPECT_NEAR(at_170().reversion(), .200, 1e-3);
}

TEST(rheometer_curve, has_zero_cure_up_to_the_minimum_and_one_at_the_maximum)
{
  const auto curve = at_160();
  EXPECT_EQ(curve.degree_of_cure(11.3), 0.);
  EXPECT_EQ(curve.degree_of_cure(30.), 0.);
  EXPECT_DOUBLE_EQ(curve.degree_of_cure(839.4), 1.);
  EXPECT_DOUBLE_EQ(curve.time_of(1.), 839.4);
}

TEST(rheometer_curve, inverts_its_own_degree_of_cure)
{
  const auto curve = at_170();
  for (const double degree : {.02, .1, .37, .5, .9, .999})
    EXPECT_NEAR(curve.degree_of_cure(curve.time_of(degree)), degree, 1e-12);
}

TEST(rheometer_curve, says_why_points_are_no_cure_curve)
{
  const auto problem = [](const std::vector<double> &times,
                          const std::vector<double> &torques) {
    return RheometerCurve::problem(times, torques);
  };
  EXPECT_EQ(problem({0, 1, 2, 3}, {1, 1, 2, 3}), "");
  EXPECT_NE(problem({0, 1, 2}, {1, 1, 2}).find("at least 4"),
            std::string::npos);
  EXPECT_NE(problem({0, 2, 1, 3}, {1, 1, 2, 3}).find("increase strictly"),
            std::string::npos);
  EXPECT_NE(problem({0, 1, 2, 3}, {1, -1, 2, 3}).find("positive torques"),
            std::string::npos);
  EXPECT_NE(problem({0, 1, 2, 3}, {4, 3, 2, 1}).find("rises"),
            std::string::npos);
  EXPECT_NE(problem({0, 1, 2, NAN}, {1, 1, 2, 3}).find("finite"),
            std::string::npos);
  EXPECT_THROW(RheometerCurve(160., {0, 1}, {1, 2}), std::invalid_argument);
}

TEST(shear_modulus, of_a_decinewton_metre_is_0_078_megapascal)
{
  // 3*100/(2 pi 20.6^3 0.0698)
  EXPECT_NEAR(shear_modulus_from_torque(1., RheometerCell()), .07825, 1e-5);
  EXPECT_NEAR(shear_modulus_from_torque(8.606, RheometerCell()),
              .67,
              .005); // theory A.3
}

TEST(arrhenius_fit, recovers_an_exact_line_without_error)
{
  const ArrheniusTime       law          = {409., 98.5, 160.};
  const std::vector<double> temperatures = {135., 150., 165., 180.};
  std::vector<double>       times;
  for (const double T : temperatures)
    times.push_back(law(T));
  const auto fit = fit_arrhenius(temperatures, times, 160.);
  EXPECT_NEAR(fit.law.reference_value, 409., 1e-9);
  EXPECT_NEAR(fit.law.activation_energy, 98.5, 1e-9);
  EXPECT_LT(fit.energy_error, 1e-9);
  EXPECT_LT(fit.prediction_error(100.), 1e-9);
}

TEST(arrhenius_fit, has_the_textbook_standard_error)
{
  // A line y = b x through three points with residuals r(1, -2, 1): symmetric
  // abscissas -d, 0, d, so that slope and mean are untouched. Then s = r
  // sqrt(6), s_slope = s/(d sqrt 2), and one more point at the middle has
  // s sqrt(1 + 1/3).
  const double        d = 5e-5, mid = 1. / kelvin(160.), r = .01;
  std::vector<double> temperatures, times;
  const double        slope = 12e3, residual[] = {r, -2 * r, r};
  for (int i = 0; i < 3; ++i)
    {
      const double x = (i - 1) * d;
      temperatures.push_back(1. / (mid + x) - 273.15);
      times.push_back(std::exp(6. + slope * x + residual[i]));
    }
  const auto fit = fit_arrhenius(temperatures, times, 160.);
  EXPECT_NEAR(fit.law.activation_energy, 12. * gas_constant, 1e-6);
  EXPECT_NEAR(fit.residual_deviation, r * std::sqrt(6.), 1e-9);
  EXPECT_NEAR(fit.energy_error,
              1e-3 * gas_constant * r * std::sqrt(6.) / (d * std::sqrt(2.)),
              1e-6);
  EXPECT_NEAR(fit.prediction_error(160.), r * std::sqrt(8.), 1e-9);
}

TEST(arrhenius_fit, of_the_measured_t90_is_98_5_within_3_kilojoule_per_mole)
{
  const auto fit = fit_arrhenius({140., 160., 170.},
                                 {at_140().time_of(.9),
                                  at_160().time_of(.9),
                                  at_170().time_of(.9)},
                                 160.);
  EXPECT_NEAR(fit.law.activation_energy, 98.5, 3.);
  EXPECT_LT(fit.energy_error, 3.);
}

TEST(arrhenius_fit, leaves_the_error_of_two_points_undefined)
{
  const auto fit = fit_arrhenius({140., 160.}, {1490., 409.}, 160.);
  EXPECT_NEAR(fit.law.reference_value, 409., 1e-9);
  EXPECT_TRUE(std::isnan(fit.energy_error));
  EXPECT_THROW(fit_arrhenius({160., 160.}, {409., 410.}, 160.),
               std::invalid_argument);
  EXPECT_THROW(fit_arrhenius({140., 160.}, {409., 0.}, 160.),
               std::invalid_argument);
}

TEST(confidence_factor, is_students_t)
{
  // Tables: 12.706 for one, 2.228 for ten degrees of freedom.
  EXPECT_NEAR(confidence_factor(.95, 1), 12.706, 1e-3);
  EXPECT_NEAR(confidence_factor(.95, 10), 2.228, 1e-3);
}

TEST(arrhenius_time, is_the_exponential_of_isayev_and_deng_in_another_form)
{
  const double t_0 = 1e-9, T_0 = 11600.;
  const auto   law = ArrheniusTime::from_exponential(t_0, T_0, 160.);
  for (const double T : {120., 160., 190.})
    EXPECT_NEAR(law(T) / (t_0 * std::exp(T_0 / kelvin(T))), 1., 1e-12);
}

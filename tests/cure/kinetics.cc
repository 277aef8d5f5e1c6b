// SPDX-License-Identifier: LGPL-2.1-or-later
// Cure over time: ARKODE against closed forms and independent quadrature.
#include "cure/cure_model.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace demold;

namespace
{
  constexpr OdeTolerances tight = {1e-12, 1e-14};

  const IsayevDeng isayev_deng = {{1.324e-2, 96., 160.}, 2.268};
  const Han han = {{1.2e-2, 95., 160.}, {4e-3, 90., 160.}, {3e-4, 110., 160.}};
  const KamalSourour kamal_sourour = {{3.7e-6, 124., 160.},
                                      {5.39e-2, 94.6, 160.},
                                      1.037,
                                      1.703};

  /// Adaptive Gauss-Kronrod quadrature, independent of ARKODE.
  template <class Function>
  double integral(const Function &f, const double from, const double to)
  {
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f,
                                                                         from,
                                                                         to,
                                                                         15,
                                                                         1e-13);
  }

  CureModel model_of(const KineticLaw    &law,
                     const ArrheniusTime &induction = ArrheniusTime())
  {
    CureModel model;
    model.kinetics = Kinetics{law, induction};
    return model;
  }

  std::vector<double> degrees(const CureModel           &model,
                              const TemperatureHistory  &temperature,
                              const std::vector<double> &times)
  {
    std::vector<double> result;
    for (const auto &state :
         integrate_cure(model, temperature, times, tight, CureState()))
      result.push_back(degree_of_cure(model, state));
    return result;
  }
} // namespace

TEST(isayev_deng, agrees_with_its_closed_form_after_the_induction)
{
  const ArrheniusTime       induction = {202.6, 96.5, 160.};
  const CureModel           model     = model_of(isayev_deng, induction);
  const std::vector<double> times     = {0., 100., 400., 900., 3000.};
  for (const double T : {140., 155., 170.})
    {
      const auto alpha = degrees(model, TemperatureHistory(T), times);
      for (std::size_t i = 0; i < times.size(); ++i)
        {
          const double x = std::max(times[i] - induction(T), 0.);
          const double z = std::pow(isayev_deng.k(T) * x, isayev_deng.n);
          EXPECT_NEAR(alpha[i], z / (1. + z), 1e-8) << T << ' ' << times[i];
        }
    }
}

TEST(isayev_deng, has_a_rate_that_is_the_derivative_of_its_closed_form)
{
  // d alpha/dt from alpha(t_1) on, which is regular, in one more integration.
  const double T = 160., start = 30.;
  OdeProblem   problem;
  problem.rate = [&](const double, const double *y, double *rate) {
    rate[0] = isayev_deng.rate(y[0], T);
  };
  OdeSolver solver(problem, start, {isayev_deng.isothermal(start, T)}, tight);
  for (const double t : {50., 200., 1000.})
    {
      solver.advance(t, 1000.);
      EXPECT_NEAR(solver.state()[0], isayev_deng.isothermal(t, T), 1e-8);
    }
}

TEST(isayev_deng, is_complete_when_the_time_overflows)
{
  EXPECT_EQ(isayev_deng.isothermal(1e300, 160.), 1.);
}

TEST(han, agrees_with_its_closed_form_and_reverts)
{
  const std::vector<double> times = {0., 20., 100., 400., 2000., 10000.};
  for (const double T : {140., 160., 180.})
    {
      const auto   alpha = degrees(model_of(han), TemperatureHistory(T), times);
      const double K1 = han.k1(T), K2 = han.k2(T), K3 = han.k3(T);
      for (std::size_t i = 0; i < times.size(); ++i)
        {
          const double t = times[i], e = std::exp(-(K1 + K2) * t);
          const double closed = K1 / (K1 + K2) * (1. - e) +
                                K2 / (K1 + K2 - K3) * (std::exp(-K3 * t) - e);
          EXPECT_NEAR(alpha[i], closed, 1e-8) << T << ' ' << t;
          EXPECT_NEAR(han.isothermal(t, T), closed, 1e-13) << T << ' ' << t;
        }
      EXPECT_LT(alpha[5], alpha[4]);
    }
}

TEST(han, has_a_closed_form_where_its_rates_coincide)
{
  // K1 + K2 = K3: the quotient of the theory is 0/0, its limit t e^{-K t}.
  const Han    law = {{.01, 0., 160.}, {.005, 0., 160.}, {.015, 0., 160.}};
  const double t = 80., e = std::exp(-.015 * t);
  const double limit = .01 / .015 * (1. - e) + .005 * t * e;
  EXPECT_NEAR(law.isothermal(t, 160.), limit, 1e-14);
  Han close                = law;
  close.k3.reference_value = .015 * (1. + 1e-9);
  EXPECT_NEAR(close.isothermal(t, 160.), limit, 1e-9);
}

TEST(kamal_sourour,
     reaches_a_degree_of_cure_after_the_integral_of_one_over_rate)
{
  const double T = 160.;
  for (const double degree : {1e-3, .1, .5, .9, .98})
    {
      // k1 is small: substitute alpha = e^x to see the start.
      const double t = integral(
        [&](const double x) {
          const double alpha = std::exp(x);
          return alpha / kamal_sourour.rate(alpha, T);
        },
        std::log(1e-16),
        std::log(degree));
      const auto alpha =
        degrees(model_of(kamal_sourour), TemperatureHistory(T), {0., t});
      EXPECT_NEAR(alpha[1], degree, 1e-8);
    }
}

TEST(equivalent_time, over_a_ramp_is_the_integral_of_the_arrhenius_factor)
{
  const CureModel model;
  const auto      ramp = TemperatureHistory::table({0., 300.}, {30., 170.});
  const auto      states =
    integrate_cure(model, ramp, {0., 150., 300., 500.}, tight, CureState());
  const auto factor = [](const double t) {
    const double T = 30. + 140. * std::min(t / 300., 1.);
    return std::exp(98.5e3 / 8.31446261815324 *
                    (1. / 433.15 - 1. / (T + 273.15)));
  };
  const double to_150 = integral(factor, 0., 150.),
               to_300 = to_150 + integral(factor, 150., 300.);
  EXPECT_EQ(states[0].f90, 0.);
  EXPECT_NEAR(states[1].f90, to_150 / 409., 1e-10);
  EXPECT_NEAR(states[2].f90, to_300 / 409., 1e-8);
  EXPECT_NEAR(states[3].f90, (to_300 + 200. * factor(300.)) / 409., 1e-8);
}

TEST(equivalent_time, of_t90_at_any_temperature_is_an_f90_of_one)
{
  const CureModel model;
  for (const double T : {140., 160., 175.})
    {
      const auto states = integrate_cure(model,
                                         TemperatureHistory(T),
                                         {0., model.t90(T)},
                                         tight,
                                         CureState());
      EXPECT_NEAR(states[1].f90, 1., 1e-10);
      EXPECT_NEAR(degree_of_cure(model, states[1]), .9, 1e-9);
    }
}

TEST(induction, ends_when_the_integral_of_its_reciprocal_is_one)
{
  // A ramp: find the end of induction by quadrature and bisection, then z by
  // quadrature.
  const ArrheniusTime induction = {202.6, 96.5, 160.};
  const auto temperature        = [](const double t) { return 100. + t / 6.; };
  const auto consumed           = [&](const double t) {
    return integral(
      [&](const double s) { return 1. / induction(temperature(s)); },
      0.,
      t);
  };
  double low = 0., high = 450.;
  for (int i = 0; i < 60; ++i)
    {
      const double middle                  = .5 * (low + high);
      (consumed(middle) < 1. ? low : high) = middle;
    }
  ASSERT_GT(low, 200.);
  ASSERT_LT(high, 440.);
  const double z =
    integral([&](const double s) { return isayev_deng.k(temperature(s)); },
             low,
             450.);
  const double z_n = std::pow(z, isayev_deng.n);

  const CureModel model = model_of(isayev_deng, induction);
  const auto      alpha =
    degrees(model, TemperatureHistory(temperature, {}), {0., .99 * low, 450.});
  EXPECT_EQ(alpha[1], 0.);
  EXPECT_NEAR(alpha[2], z_n / (1. + z_n), 1e-8);
}

TEST(cure, does_not_depend_on_the_times_asked_for)
{
  const CureModel model = model_of(kamal_sourour, {60., 90., 160.});
  const auto      cycle =
    TemperatureHistory::table({0., 60., 500., 700.}, {30., 165., 165., 40.});
  std::vector<double> many;
  for (int i = 0; i <= 700; ++i)
    many.push_back(i);
  EXPECT_NEAR(degrees(model, cycle, many).back(),
              degrees(model, cycle, {0., 700.}).back(),
              1e-9);
}

TEST(cure, goes_on_from_a_state)
{
  const CureModel          model = model_of(han, {60., 90., 160.});
  const TemperatureHistory temperature(160.);
  const auto               whole =
    integrate_cure(model, temperature, {0., 20., 300.}, tight, CureState());
  const auto rest =
    integrate_cure(model, temperature, {20., 300.}, tight, whole[1]);
  EXPECT_LT(whole[1].induction, 1.);
  EXPECT_NEAR(rest[1].f90, whole[2].f90, 1e-10);
  EXPECT_NEAR(degree_of_cure(model, rest[1]),
              degree_of_cure(model, whole[2]),
              1e-10);
}

TEST(cure, ends_with_the_exception_of_its_temperature)
{
  const TemperatureHistory broken(
    [](const double t) -> double {
      if (t > 10.)
        throw std::domain_error("no temperature");
      return 160.;
    },
    {});
  EXPECT_THROW(
    integrate_cure(CureModel(), broken, {0., 20.}, tight, CureState()),
    std::domain_error);
}

TEST(isothermal_degree_of_cure, is_what_the_integration_gives)
{
  const std::vector<double> times = {50., 300., 800.};
  const ArrheniusTime       wait  = {60., 90., 160.};
  for (const KineticLaw &law :
       {KineticLaw(kamal_sourour), KineticLaw(isayev_deng), KineticLaw(han)})
    {
      const auto first =
        isothermal_degree_of_cure({law, wait}, 165., times, tight);
      const auto second = degrees(model_of(law, wait),
                                  TemperatureHistory(165.),
                                  {0., 50., 300., 800.});
      ASSERT_EQ(first.size(), 3u);
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(first[i], second[i + 1], 1e-8);
    }
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Heat in a slab against the series of Carslaw and Jaeger.
#include "cure/press_cycle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace demold;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  ThermalSide perfect(const double temperature)
  {
    ThermalSide side;
    side.contact     = ThermalSide::perfect;
    side.temperature = TemperatureHistory(temperature);
    return side;
  }

  /// A slab 0 < x < L at T_0, its surfaces kept at T_a and T_b from t = 0 on
  /// (Carslaw and Jaeger, Conduction of Heat in Solids, chapter 3).
  double both_sides(const double x,
                    const double t,
                    const double L,
                    const double a,
                    const double T_0,
                    const double T_a,
                    const double T_b)
  {
    double T = T_a + (T_b - T_a) * x / L;
    for (int n = 1; n < 400; ++n)
      {
        const double sign = n % 2 == 0 ? 1. : -1.;
        T += 2. / (n * pi) * (T_b * sign - T_a + T_0 * (1. - sign)) *
             std::sin(n * pi * x / L) *
             std::exp(-a * n * n * pi * pi * t / (L * L));
      }
    return T;
  }

  PressCycle heated(const ThermalSide &mould, const ThermalSide &bladder)
  {
    PressCycle cycle;
    cycle.initial_temperature = 30.;
    cycle.mould               = mould;
    cycle.bladder             = bladder;
    cycle.opening_time        = 600.;
    cycle.end_time            = 600.;
    return cycle;
  }
} // namespace

TEST(slab, between_two_temperatures_follows_the_series_within_half_a_percent)
{
  const SlabHistory slab(heated(perfect(170.), perfect(150.)), 8., 32);
  for (const double x : {1., 2., 4., 6., 7.9})
    for (const double t : {10., 30., 100., 400., 600.})
      EXPECT_NEAR(slab.at(x)(t),
                  both_sides(x, t, 8., .12, 30., 170., 150.),
                  .005 * 140.)
        << x << ' ' << t;
}

TEST(slab, heated_from_one_side_is_half_of_a_slab_of_twice_the_thickness)
{
  const SlabHistory slab(heated(perfect(170.), ThermalSide()), 8., 32);
  for (const double x : {1., 4., 8.})
    for (const double t : {20., 100., 216., 600.})
      EXPECT_NEAR(slab.at(x)(t),
                  both_sides(x, t, 16., .12, 30., 170., 170.),
                  .005 * 140.);
  // The slowest mode: L^2/(a pi^2/4) = 216 s (theory A.3).
  const auto   back = slab.at(8.);
  const double decay =
    std::log((170. - back(300.)) / (170. - back(500.))) / 200.;
  EXPECT_NEAR(1. / decay, 64. / (.12 * pi * pi / 4.), 1.);
}

TEST(slab, converges_with_the_square_of_the_element_size)
{
  PressCycle cycle = heated(perfect(170.), perfect(150.));
  cycle.tolerances = {1e-9, 1e-9};
  double error[2];
  for (const unsigned int n : {8u, 16u})
    error[n / 16] = std::abs(SlabHistory(cycle, 8., n).at(4.)(100.) -
                             both_sides(4., 100., 8., .12, 30., 170., 150.));
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2., .1);
}

TEST(slab, cools_through_a_film_as_the_roots_of_biot_say)
{
  // Insulated at the back: T = T_air + (T_0 - T_air) sum C_n cos(z_n y)
  // exp(-z_n^2 Fo), y from the back, z tan z = Bi, C = 4 sin z/(2z + sin 2z)
  // (Carslaw and Jaeger, chapter 3).
  ThermalSide film;
  film.contact              = ThermalSide::film;
  film.film_coefficient     = .05;
  film.temperature          = TemperatureHistory(25.);
  PressCycle cycle          = heated(film, ThermalSide());
  cycle.initial_temperature = 165.;
  const double      Bi      = .05 * 8. / .27;
  const SlabHistory slab(cycle, 8., 32);
  for (const double depth : {0., 4., 8.})
    for (const double t : {20., 100., 500.})
      {
        double share = 0.;
        for (int n = 0; n < 40; ++n)
          {
            double low = n * pi + 1e-12, high = (n + .5) * pi - 1e-12;
            for (int i = 0; i < 80; ++i)
              {
                const double z                      = .5 * (low + high);
                (z * std::tan(z) < Bi ? low : high) = z;
              }
            share += 4. * std::sin(low) / (2. * low + std::sin(2. * low)) *
                     std::cos(low * (1. - depth / 8.)) *
                     std::exp(-low * low * .12 * t / 64.);
          }
        EXPECT_NEAR(slab.at(depth)(t), 25. + 140. * share, .005 * 140.);
      }
}

TEST(slab, without_heat_flux_keeps_its_heat)
{
  const ThermalNetwork network = slab_network(ThermalMaterial(), 8., 16);
  std::vector<double>  T(17);
  for (unsigned int i = 0; i < 17; ++i)
    T[i] = 30. + i * i;
  const auto heat = [&]() {
    return std::inner_product(T.begin(), T.end(), network.capacity.begin(), 0.);
  };
  const double before = heat();
  conduct_heat(network,
               {ThermalSide(), ThermalSide()},
               0.,
               5000.,
               {1e-8, 1e-8},
               T,
               [](const ThermalStep &) {});
  EXPECT_NEAR(heat() / before, 1., 1e-10);
  EXPECT_NEAR(T.front(), T.back(), 1e-4);
}

TEST(slab, follows_its_mould_before_the_opening_and_cools_afterwards)
{
  ThermalSide mould = perfect(0.);
  mould.temperature =
    TemperatureHistory::table({0., 100., 200.}, {60., 160., 165.});
  PressCycle cycle           = heated(mould, perfect(160.));
  cycle.opening_time         = 300.;
  cycle.air.contact          = ThermalSide::film;
  cycle.air.film_coefficient = .02;
  cycle.air.temperature      = TemperatureHistory(25.);
  const SlabHistory slab(cycle, 8., 16);
  EXPECT_DOUBLE_EQ(slab.at(0.)(50.), 110.);
  EXPECT_DOUBLE_EQ(slab.at(0.)(250.), 165.);
  EXPECT_NEAR(slab.at(0.)(300.001), 165., .1);
  EXPECT_LT(slab.at(0.)(330.), 163.);
  EXPECT_LT(slab.at(8.)(600.), slab.at(8.)(310.));
}

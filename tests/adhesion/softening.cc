// SPDX-License-Identifier: LGPL-2.1-or-later
// Softening laws keep their closed forms: peak, rupture, energy, slopes.
#include "adhesion/softening.h"

#include <boost/math/special_functions/lambert_w.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace demold
{
  const LinearSoftening      bilinear{0.2, 0.1, 20.};
  const ExponentialSoftening exponential{0.2, 0.05, 20.};

  template <typename Law>
  class EverySoftening : public testing::Test
  {
  public:
    static Law law()
    {
      return {0.2, 0.07, 20.};
    }
  };
  using Laws = testing::Types<LinearSoftening, ExponentialSoftening>;
  TYPED_TEST_SUITE(EverySoftening, Laws);

  TYPED_TEST(EverySoftening, reaches_its_strength_at_the_onset_gap)
  {
    const auto law = this->law();
    EXPECT_DOUBLE_EQ(law.onset_gap(), 0.2 / 20.);
    EXPECT_NEAR(law.secant(law.onset_gap()) * law.onset_gap(), 0.2, 1e-15);
    EXPECT_NEAR(law.on_curve(law.onset_gap()).limit, 0.2, 1e-15);
  }

  TYPED_TEST(EverySoftening, carries_nothing_from_the_rupture_gap_on)
  {
    const auto law = this->law();
    EXPECT_EQ(law.secant(law.rupture_gap()), 0.);
    EXPECT_EQ(law.secant(2. * law.rupture_gap()), 0.);
    EXPECT_EQ(law.secant_derivative(2. * law.rupture_gap()), 0.);
    EXPECT_GT(law.secant(0.999 * law.rupture_gap()), 0.);
  }

  TYPED_TEST(EverySoftening, secant_derivative_matches_differences)
  {
    const auto law = this->law();
    for (const double part : {0.001, 0.01, 0.1, 0.4, 0.8, 0.98})
      {
        const double kappa =
          law.onset_gap() + part * (law.rupture_gap() - law.onset_gap());
        const double h = 1e-5 * (kappa - law.onset_gap());
        const double slope =
          (law.secant(kappa + h) - law.secant(kappa - h)) / (2. * h);
        EXPECT_NEAR(law.secant_derivative(kappa) / slope, 1., 1e-6) << kappa;
      }
  }

  // Work by Simpson's rule less what is stored: an independent path to C6.
  TYPED_TEST(EverySoftening, dissipates_the_work_that_is_not_stored)
  {
    const auto         law    = this->law();
    const unsigned int n      = 20000;
    const double       top    = 0.9 * law.rupture_gap();
    const double       length = (top - law.onset_gap()) / n;
    double             work   = 0.5 * 0.2 * law.onset_gap();
    for (unsigned int i = 0; i < n; ++i)
      {
        const double x = law.onset_gap() + i * length;
        const auto   t = [&](const double k) { return law.on_curve(k).limit; };
        work += length / 6. * (t(x) + 4. * t(x + length / 2.) + t(x + length));
      }
    const double stored = 0.5 * law.on_curve(top).limit * top;
    EXPECT_NEAR(law.dissipated(top) / (work - stored), 1., 1e-10);
  }

  TYPED_TEST(EverySoftening, dissipates_the_fracture_energy_at_rupture)
  {
    const auto law = this->law();
    EXPECT_EQ(law.dissipated(law.onset_gap()), 0.);
    EXPECT_EQ(law.dissipated(law.rupture_gap()), law.fracture_energy());
    double last = 0.;
    for (double part = 0.; part < 1.1; part += 0.01)
      {
        const double now = law.dissipated(part * law.rupture_gap());
        EXPECT_GE(now, last);
        last = now;
      }
  }

  TYPED_TEST(EverySoftening, is_steepest_where_it_says)
  {
    const auto law = this->law();
    EXPECT_NEAR(law.steepest_slope(),
                -law.on_curve(law.onset_gap()).slope,
                1e-12 * law.steepest_slope());
    for (double part = 0.; part < 1.; part += 0.05)
      EXPECT_LE(-law.on_curve(law.onset_gap() + part * law.rupture_gap()).slope,
                law.steepest_slope() * (1. + 1e-12));
  }

  // The mortar formulation's onset: nothing gives before the limit is reached.
  TYPED_TEST(EverySoftening, allows_an_infinite_penalty)
  {
    auto law    = this->law();
    law.penalty = std::numeric_limits<double>::infinity();
    EXPECT_EQ(law.onset_gap(), 0.);
    const double small = 1e-9 * law.gap;
    EXPECT_NEAR(law.secant(small) * small, 0.2, 1e-8);
    EXPECT_NEAR(law.dissipated(small), 0.5 * 0.2 * small, 1e-8 * small);
    EXPECT_EQ(law.dissipated(law.rupture_gap()), law.fracture_energy());
    EXPECT_LT(law.secant_derivative(small), 0.);
  }

  // Theory C3, C5, C6.
  TEST(linear_softening, has_the_bilinear_closed_form)
  {
    const double delta = 0.1, onset = 0.01;
    EXPECT_DOUBLE_EQ(bilinear.fracture_energy(), 0.5 * 0.2 * delta);
    for (const double kappa : {0.02, 0.03, 0.055, 0.08, 0.0999})
      {
        const double limit = 0.2 * (delta - kappa) / (delta - onset);
        const double g_d   = kappa - limit / 20.;
        EXPECT_NEAR(limit, 0.2 * (1. - g_d / delta), 1e-15);
        EXPECT_NEAR(bilinear.secant(kappa), limit / kappa, 1e-13);
        EXPECT_NEAR(bilinear.secant_derivative(kappa),
                    -0.2 * delta / (kappa * kappa * (delta - onset)),
                    1e-10);
        EXPECT_NEAR(bilinear.dissipated(kappa), 0.5 * 0.2 * g_d, 1e-16);
      }
  }

  // x + q exp(-x) = K is solved by x = K + W_0(-q exp(-K)).
  TEST(exponential_softening, solves_its_decohesion_gap_to_round_off)
  {
    for (const double penalty : {4.0001, 4.1, 20., 400., 1e6})
      {
        const ExponentialSoftening law{0.2, 0.05, penalty};
        const double               q = law.onset_gap() / law.gap;
        for (const double beyond : {0.01, 0.3, 1., 4., 12., 40.})
          {
            const double kappa = law.onset_gap() + beyond * law.gap;
            const double K     = kappa / law.gap;
            const double x     = K + boost::math::lambert_w0(-q * std::exp(-K));
            EXPECT_NEAR(law.decohesion_gap(kappa) / (law.gap * x), 1., 1e-11)
              << penalty << ' ' << beyond;
            const double back =
              law.decohesion_gap(kappa) +
              0.2 / penalty * std::exp(-law.decohesion_gap(kappa) / law.gap);
            EXPECT_NEAR(back / kappa, 1., 4e-16);
          }
      }
  }

  // Just behind the onset x = r/(1-q) + O(r^2): no digits may be lost.
  TEST(exponential_softening, loses_no_digits_at_the_onset)
  {
    const double q = exponential.onset_gap() / exponential.gap;
    for (const double g_d : {1e-4, 1e-6, 1e-8})
      {
        const double kappa = exponential.onset_gap() + g_d * (1. - q) +
                             0.5 * q * g_d * g_d / exponential.gap;
        // What is left is round-off of kappa itself and the next term.
        EXPECT_NEAR(exponential.decohesion_gap(kappa),
                    g_d,
                    4e-18 / (1. - q) + std::pow(g_d, 3) / 0.0025);
      }
  }

  TEST(exponential_softening, counts_the_cut_in_its_fracture_energy)
  {
    const double whole = 0.2 * 0.05;
    EXPECT_NEAR(exponential.fracture_energy() / whole, 1., 1.1e-6);
    EXPECT_NEAR(exponential.secant(exponential.rupture_gap() * (1. - 1e-12)) *
                  exponential.rupture_gap() / 0.2,
                ExponentialSoftening::residual_limit,
                1e-15);
    // What the cut loses at once is exactly what is stored there.
    const double just_before = exponential.rupture_gap() * (1. - 1e-12);
    const double stored =
      0.5 * exponential.secant(just_before) * just_before * just_before;
    EXPECT_NEAR(exponential.fracture_energy() -
                  exponential.dissipated(just_before),
                stored,
                1e-5 * stored);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Work done on the rubber is stored or dissipated, and nothing else.
#include "material/overstress.h"

#include "random_deformation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace demold;

namespace
{
  /// Those with a stored energy and of second order.
  constexpr Variant second_order[] = {all_variants[0],
                                      all_variants[3],
                                      all_variants[4]};

  struct Ledger
  {
    double work = 0., dissipated = 0., stored = 0., largest = 0.;

    double gap() const
    {
      return std::abs(work - dissipated - stored) / largest;
    }
  };

  /// Follows F(t); the work is S : dC/2 by the trapezoidal rule.
  Ledger follow(const RubberLaw                           &law,
                const std::function<Tensor<2, 3>(double)> &F,
                const double                               end,
                const unsigned int                         n_steps)
  {
    Point  point(law);
    Ledger ledger;
    auto   C = right_cauchy_green(F(0.));
    auto   S = point.move_to(F(0.), 0.).S;
    for (unsigned int i = 1; i <= n_steps; ++i)
      {
        const double t     = end * i / n_steps;
        const auto   C_new = right_cauchy_green(F(t));
        const auto   S_new = point.move_to(F(t), end / n_steps).S;
        ledger.work += .25 * ((S + S_new) * (C_new - C));
        ledger.dissipated += point.response.dissipated;
        ledger.stored = point.response.stored;
        ledger.largest =
          std::max({ledger.largest, std::abs(ledger.work), ledger.dissipated});
        C = C_new;
        S = S_new;
      }
    return ledger;
  }

  RubberLaw three_branches(const Variant &variant)
  {
    RubberLaw law;
    law.elastic    = MooneyRivlin{50., .4, .1};
    law.branches   = {{.3, .05}, {.5, .5}, {.2, 5.}};
    law.branch_law = variant.branch_law;
    law.update     = variant.update;
    return law;
  }

  /// Rate of C_i and dissipation (theory A8, A.2; mu = tau = 1).
  Tensor<2, 3> rate_of_metric(const BranchLaw     law,
                              const Tensor<2, 3> &C,
                              const Tensor<2, 3> &Ci,
                              double             &D)
  {
    const Tensor<2, 3> one(dealii::unit_symmetric_tensor<3>());
    if (law == BranchLaw::isochoric)
      {
        const Tensor<2, 3> Cbar = C * std::pow(determinant(C), -1. / 3.);
        const Tensor<2, 3> X    = Cbar * invert(Ci);
        D = .5 * (trace(X * X) - trace(X) * trace(X) / 3.);
        return Cbar - trace(X) / 3. * Ci;
      }
    // Similar to b_e: the traces are the same.
    const Tensor<2, 3> b_e = C * invert(Ci), excess = b_e - one;
    if (law == BranchLaw::linear)
      {
        D = .5 * trace(excess * excess);
        return C - Ci;
      }
    D = .5 * trace(excess * excess * invert(b_e));
    return -1. * (Ci * (invert(C) - invert(Ci)) * Ci);
  }

  /// Independent path: Runge-Kutta for the evolution equation of C_i and the
  /// dissipated energy, along F(t).
  double reference_dissipation(const BranchLaw                            law,
                               const std::function<Tensor<2, 3>(double)> &F,
                               const double                               end)
  {
    using Tensor2   = Tensor<2, 3>;
    const auto rate = [&](const double t, const Tensor2 &Ci, double &D) {
      return rate_of_metric(law, transpose(F(t)) * F(t), Ci, D);
    };
    Tensor2            Ci(dealii::unit_symmetric_tensor<3>());
    double             sum = 0., D1, D2, D3, D4;
    const unsigned int n   = 2000;
    const double       h   = end / n;
    for (unsigned int i = 0; i < n; ++i)
      {
        const Tensor2 k1 = rate(i * h, Ci, D1);
        const Tensor2 k2 = rate((i + .5) * h, Ci + .5 * h * k1, D2);
        const Tensor2 k3 = rate((i + .5) * h, Ci + .5 * h * k2, D3);
        const Tensor2 k4 = rate((i + 1) * h, Ci + h * k3, D4);
        Ci += h / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
        sum += h / 6. * (D1 + 2. * D2 + 2. * D3 + D4);
      }
    return sum;
  }

  Tensor<2, 3> ramp(const double t)
  {
    return simple_shear(t);
  }

  Tensor<2, 3> held(const double)
  {
    return simple_shear(1.);
  }
} // namespace

TEST(energy_balance, closes_over_cycles_of_shear)
{
  for (const Variant &variant : all_variants)
    {
      const auto cycles = [](const double t) {
        return simple_shear(.6 * std::sin(2. * M_PI * t));
      };
      const Ledger ledger = follow(three_branches(variant), cycles, 3., 600);
      EXPECT_GT(ledger.dissipated, .1 * ledger.work) << variant.name;
      EXPECT_LT(ledger.gap(), variant.update == ViscousUpdate::be ? .02 : 1e-3)
        << variant.name;
    }
}

TEST(energy_balance, closes_with_second_order)
{
  const auto cycle = [](const double t) {
    const double s = std::sin(2. * M_PI * t);
    return simple_shear(.6 * s) * stretches(1. + .2 * s * s, 1., 1.);
  };
  for (const Variant &variant : second_order)
    {
      const RubberLaw law    = three_branches(variant);
      const double    coarse = follow(law, cycle, 1., 100).gap();
      const double    fine   = follow(law, cycle, 1., 200).gap();
      EXPECT_NEAR(std::log2(coarse / fine), 2., .2) << variant.name;
    }
}

TEST(dissipation, converges_with_second_order_to_the_differential_equation)
{
  for (const Variant &variant : second_order)
    for (const auto &path : {ramp, held})
      {
        const RubberLaw law = bare_branch(variant);
        const double    reference =
          reference_dissipation(law.branch_law, path, 2.);
        const auto error = [&](const unsigned int n) {
          return std::abs(follow(law, path, 2., n).dissipated - reference);
        };
        EXPECT_NEAR(std::log2(error(40) / error(80)), 2., .15) << variant.name;
        EXPECT_LT(error(80), 1e-3 * reference) << variant.name;
      }
}

// At constant strain no work is done: all that a branch stored is dissipated.
// With the other two laws the estimate of one long step is as good up to a
// shear of 0.3; beyond, it must only not fall short.
TEST(dissipation, of_one_relaxing_step_is_the_stored_energy_lost)
{
  for (const Variant &variant : second_order)
    for (const double gamma : {.01, .3, 1., 2.})
      for (const double dt : {.01, .1, 1., 3., 10., 1e4})
        {
          Point point(bare_branch(variant));
          point.move_to(simple_shear(gamma), 0.);
          const double before = point.response.stored;
          EXPECT_NEAR(before, .5 * gamma * gamma, 1e-12);
          point.move_to(simple_shear(gamma), dt);
          const double ratio =
            point.response.dissipated / (before - point.response.stored);
          const bool isochoric = variant.branch_law == BranchLaw::isochoric;
          EXPECT_GT(ratio, .97)
            << variant.name << ", gamma = " << gamma << ", dt = " << dt;
          EXPECT_LT(ratio, isochoric || gamma < 1. ? 1.03 : 1.4)
            << variant.name << ", gamma = " << gamma << ", dt = " << dt;
        }
}

// Steady flow at small strain: x = rate tau, D = mu rate^2 tau.
TEST(dissipation, of_long_steps_in_steady_flow_is_that_of_the_dashpot)
{
  const double rate = 1e-6, dt = 50.;
  for (const Variant &variant : second_order)
    {
      Point point(bare_branch(variant));
      point.move_to(simple_shear(rate * dt), dt);
      point.move_to(simple_shear(2. * rate * dt), dt);
      EXPECT_NEAR(point.response.dissipated / (rate * rate * dt), 1., 1e-3)
        << variant.name;
    }
}

TEST(dissipation, is_never_negative)
{
  std::mt19937                           generator(9);
  std::uniform_real_distribution<double> exponent(-4., 4.);
  for (const Variant &variant : all_variants)
    {
      if (variant.branch_law == BranchLaw::convolution)
        continue; // does not claim it
      Point point(three_branches(variant));
      for (unsigned int i = 0; i < 2000; ++i)
        {
          point.move_to(random_gradient(generator, .3),
                        std::pow(10., exponent(generator)));
          ASSERT_GE(point.response.dissipated, 0.);
          ASSERT_TRUE(std::isfinite(point.response.dissipated));
        }
    }
}

// The two ways of integration meet where they are exchanged (h = 0.02).
TEST(dissipation, is_continuous_in_the_length_of_the_step)
{
  Nine M{{1.1, .3, 0., .3, 1., 0., 0., 0., 1.}};
  M[8] = 1. / (1.1 - .09);
  const Overstress start(M);
  M = {{1., .1, 0., .1, 1.01, 0., 0., 0., 1.}};
  const Overstress end(M);
  const auto       per_time = [&](const double h) {
    return dissipation_over_step(start, end, h) / h;
  };
  const double at = .02 / 1.01;
  for (double h = .8 * at; h < 1.2 * at; h *= 1.001)
    EXPECT_NEAR(per_time(h * 1.001) / per_time(h), 1., 1e-4);
}

TEST(overstress, keeps_the_digits_of_the_energy_near_equilibrium)
{
  for (const double e : {1e-9, 1e-6, 2e-4, 3e-4, 1e-3, .3})
    {
      // be_bar = diag(exp(2 e), exp(-2 e), 1): 2 W/mu = 4 sinh(e)^2
      const double     x = std::exp(e);
      const Overstress sheared(
        Nine{{x * x, 0., 0., 0., 1. / (x * x), 0., 0., 0., 1.}});
      EXPECT_NEAR(sheared.energy / (4. * std::sinh(e) * std::sinh(e)), 1., 1e-6)
        << e;
      // be_bar = diag(x^2, 1/x, 1/x): 2 W/mu = (x-1)^2 (x+2)/x
      const Overstress stretched(
        Nine{{x * x, 0., 0., 0., 1. / x, 0., 0., 0., 1. / x}});
      EXPECT_NEAR(stretched.energy /
                    (std::expm1(e) * std::expm1(e) * (x + 2.) / x),
                  1.,
                  1e-6)
        << e;
    }
}

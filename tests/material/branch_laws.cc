// SPDX-License-Identifier: LGPL-2.1-or-later
// Every branch law relaxes as its own differential equation says.
#include "random_deformation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace demold;

namespace
{
  constexpr Variant V1 = all_variants[0], BE = all_variants[1],
                    V2 = all_variants[3], V3 = all_variants[4],
                    V4 = all_variants[5];

  /// Kirchhoff stress after a jump to @p F held for @p t in @p n steps.
  Tensor<2, 3> relaxed(const Variant      &variant,
                       const Tensor<2, 3> &F,
                       const double        t,
                       const unsigned int  n)
  {
    Point point(bare_branch(variant));
    point.move_to(F, 0.);
    for (unsigned int i = 0; i < n; ++i)
      point.move_to(F, t / n);
    return point.kirchhoff(F);
  }

  /// Kirchhoff stress after the shear ramp gamma = t/tau to 1 in n steps.
  Tensor<2, 3> ramped(const Variant &variant, const unsigned int n)
  {
    Point point(bare_branch(variant));
    for (unsigned int i = 1; i <= n; ++i)
      point.move_to(simple_shear(double(i) / n), 1. / n);
    return point.kirchhoff(simple_shear(1.));
  }

  /// s(t) of ds/dt = rate(s), s(0) = 0, tau = 1, by Runge-Kutta.
  double integrated(const std::function<double(double)> &rate, const double t)
  {
    double             s = 0.;
    const unsigned int n = 4000;
    const double       h = t / n;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double k1 = rate(s);
        const double k2 = rate(s + .5 * h * k1);
        const double k3 = rate(s + .5 * h * k2);
        const double k4 = rate(s + h * k3);
        s += h / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
      }
    return s;
  }

  /// tau_12/mu of V1 at t after a step of shear (theory E.9, A = 1 + s C).
  double relaxed_shear(const double gamma, const double t)
  {
    const auto d = [&](const double s) {
      return (1. + s) * (1. + s) + s * gamma * gamma;
    };
    const double s =
      integrated([&](double s) { return std::cbrt((1. + s) * d(s)); }, t);
    return gamma * std::cbrt((1. + s) * d(s)) / d(s);
  }

  /// sigma/mu of V1 at t after an isochoric uniaxial step (theory E.9).
  double relaxed_stretch(const double l, const double t)
  {
    const auto D = [&](const double s) {
      return std::cbrt((1. + s * l * l) * (1. + s / l) * (1. + s / l));
    };
    const double s = integrated(D, t);
    return D(s) * (l * l / (1. + s * l * l) - 1. / (l + s));
  }

  Tensor<2, 3> uniaxial(const double stretch)
  {
    return stretches(stretch, 1. / std::sqrt(stretch), 1. / std::sqrt(stretch));
  }

  double order(const std::function<double(unsigned int)> &value,
               const double                               reference,
               const unsigned int                         n)
  {
    return std::log2((value(n) - reference) / (value(2 * n) - reference));
  }
} // namespace

// Against theory E.9 by Runge-Kutta, whose own values E.9 confirms.
TEST(relaxation, is_of_second_order_with_exp2_and_of_first_with_be)
{
  EXPECT_NEAR(relaxed_shear(1., 1.), .30170331, 6e-9);
  EXPECT_NEAR(relaxed_stretch(1.5, 1.), .41171949, 6e-9);

  for (const double size : {.5, 1., 2.})
    {
      const auto shear = [&](const Variant &variant) {
        return order(
          [&](const unsigned int n) {
            return relaxed(variant, simple_shear(size), 1., n)[0][1];
          },
          relaxed_shear(size, 1.),
          80);
      };
      EXPECT_NEAR(shear(V1), 2., .05) << size;
      EXPECT_NEAR(shear(BE), 1., .05) << size;

      const auto stretch = [&](const Variant &variant) {
        return order(
          [&](const unsigned int n) {
            const auto tau = relaxed(variant, uniaxial(1. + size), 1., n);
            return tau[0][0] - tau[1][1];
          },
          relaxed_stretch(1. + size, 1.),
          80);
      };
      EXPECT_NEAR(stretch(V1), 2., .1) << size;
      EXPECT_NEAR(stretch(BE), 1., .1) << size;
    }
}

TEST(relaxation, meets_the_differential_equation_with_small_steps)
{
  for (const double t : {.5, 1., 2.})
    {
      EXPECT_NEAR(relaxed(V1, simple_shear(1.), t, 2000)[0][1],
                  relaxed_shear(1., t),
                  1e-6);
      const auto tau = relaxed(V1, uniaxial(2.), t, 2000);
      EXPECT_NEAR(tau[0][0] - tau[1][1], relaxed_stretch(2., t), 1e-6);
    }
}

// V2: tau_12 = mu gamma e/(1 + e (1-e) gamma^2), e = exp(-t/tau), and in
// uniaxial extension b_e = l^2/(e + (1-e) l^2) (theory E.9).
TEST(linear_evolution, relaxes_exactly_in_one_step)
{
  const double listed[] = {.48967026, .29847161, .12115748};
  unsigned int i        = 0;
  for (const double t : {.5, 1., 2.})
    {
      const double e   = std::exp(-t);
      const double tau = relaxed(V2, simple_shear(1.), t, 1)[0][1];
      EXPECT_NEAR(tau, e / (1. + e * (1. - e)), 1e-14);
      EXPECT_NEAR(tau, listed[i++], 6e-9);

      const auto b_e = [&](const double l) {
        return l * l / (e + (1. - e) * l * l);
      };
      const auto stretched = relaxed(V2, uniaxial(2.), t, 1);
      EXPECT_NEAR(stretched[0][0] - stretched[1][1],
                  b_e(2.) - b_e(1. / std::sqrt(2.)),
                  1e-13);
    }
}

// V3: b_e - 1 = exp(-t/tau) (b - 1), whatever the deformation.
TEST(lubliner, relaxes_exactly_in_one_step)
{
  std::mt19937 generator(4);
  for (const double t : {.5, 1., 2.})
    {
      const auto         F = random_gradient(generator, .4);
      const Tensor<2, 3> excess =
        F * transpose(F) - Tensor<2, 3>(dealii::unit_symmetric_tensor<3>());
      EXPECT_LT((relaxed(V3, F, t, 1) - std::exp(-t) * excess).norm(), 1e-13);
    }
}

// V4: all of the isochoric neo-Hooke stress dev(b_bar) fades alike.
TEST(stress_convolution, relaxes_exactly_in_one_step)
{
  std::mt19937 generator(4);
  for (const double t : {.5, 1., 2.})
    {
      const auto         F = random_gradient(generator, .4);
      const Tensor<2, 3> b_bar =
        F * transpose(F) * std::pow(determinant(F), -2. / 3.);
      const Tensor<2, 3> dev =
        b_bar -
        trace(b_bar) / 3. * Tensor<2, 3>(dealii::unit_symmetric_tensor<3>());
      EXPECT_LT((relaxed(V4, F, t, 1) - std::exp(-t) * dev).norm(), 1e-13);
    }
}

// gamma = t/tau up to 1. V2: theory E.9. V3, the upper-convected fluid:
// tau_12 = 1 - 1/e, tau_11 = 2 - 4/e. V4 with S_12 = gamma (1 + gamma^2/3),
// S_22 = -gamma^2/3: the integral of exp(-(1-t)) d(t^n) is n I_n-1 with
// I_n = 1 - n I_n-1.
TEST(shear_ramp, is_met_with_second_order)
{
  const auto stress = [](const Variant &variant, const unsigned int component) {
    return [variant, component](const unsigned int n) {
      return ramped(variant, n)[0][component];
    };
  };
  const auto expect_order_two = [&](const Variant     &variant,
                                    const unsigned int component,
                                    const double       reference) {
    EXPECT_NEAR(order(stress(variant, component), reference, 20), 2., .05)
      << variant.name;
    EXPECT_NEAR(stress(variant, component)(400), reference, 2e-6)
      << variant.name;
  };
  expect_order_two(V1, 1, .5774801429);
  expect_order_two(V2, 1, .5599409088);
  expect_order_two(V3, 0, 2. - 4. * std::exp(-1.));
  EXPECT_NEAR(stress(V3, 1)(400), 1. - std::exp(-1.), 2e-6);

  const double I0 = 1. - std::exp(-1.), I1 = 1. - I0, I2 = 1. - 2. * I1;
  expect_order_two(V4, 1, I0 + I2 - 2. / 3. * I1);
}

// Linear viscoelasticity: a ramp to gamma in t gives mu gamma (1-e) tau/t.
TEST(all_branch_laws, are_exact_in_one_step_at_small_shear)
{
  const double gamma = 1e-6;
  for (const Variant &variant : {V1, V2, V3, V4})
    for (const double t : {1e-6, 4e-3, 6e-3, 1., 20.})
      {
        Point point(bare_branch(variant));
        point.move_to(simple_shear(gamma), t);
        EXPECT_NEAR(point.kirchhoff(simple_shear(gamma))[0][1] / gamma,
                    -std::expm1(-t) / t,
                    1e-9)
          << variant.name;
      }
}

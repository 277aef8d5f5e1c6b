// SPDX-License-Identifier: LGPL-2.1-or-later
// Maxwell branches relax as the differential equation at finite strain says.
#include "random_deformation.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace demold;

namespace
{
  constexpr ViscousUpdate all_updates[] = {ViscousUpdate::exp2,
                                           ViscousUpdate::be,
                                           ViscousUpdate::lin};

  /// tau_12/mu after the shear ramp gamma = t/tau to 1 in n steps.
  double stress_after_ramp(const ViscousUpdate update, const unsigned int n)
  {
    Point point(bare_branch(update));
    for (unsigned int i = 1; i <= n; ++i)
      point.move_to(simple_shear(double(i) / n), 1. / n);
    return point.kirchhoff(simple_shear(1.))[0][1];
  }

  double observed_order(const ViscousUpdate update, const unsigned int n)
  {
    const double reference = .5774801429; // theory A.2, E.9
    return std::log2(std::abs((stress_after_ramp(update, n) - reference) /
                              (stress_after_ramp(update, 2 * n) - reference)));
  }

  /// Jumps to F and holds; calls record at t = 0.5, 1, 2 tau.
  template <typename Record>
  void relax(const Tensor<2, 3> &F, const Record &record)
  {
    const unsigned int n = 4000;
    Point              point(bare_branch(ViscousUpdate::exp2));
    point.move_to(F, 0.);
    for (unsigned int i = 1; i <= n; ++i)
      {
        point.move_to(F, 2. / n);
        if (i == n / 4 || i == n / 2 || i == n)
          record(point.kirchhoff(F));
      }
  }
} // namespace

// Expected values: theory E.9, variant V1, t/tau = 0.5, 1, 2.
TEST(shear_step, relaxes_to_the_reference_values)
{
  const double expected[4][4] = {{.1, .06054113, .03670660, .01350617},
                                 {.5, .28987962, .17430821, .06442087},
                                 {1., .51221132, .30170331, .11288969},
                                 {2., .70173506, .39643340, .15355218}};
  for (const auto &row : expected)
    {
      unsigned int i = 1;
      relax(simple_shear(row[0]), [&](const Tensor<2, 3> &tau) {
        EXPECT_NEAR(tau[0][1], row[i++], 1e-7);
      });
    }
}

TEST(uniaxial_step, relaxes_to_the_reference_values)
{
  const double expected[3][4] = {{1.2, .33736863, .19526628, .06888041},
                                 {1.5, .75759036, .41171949, .13843909},
                                 {2., 1.27788739, .64082930, .20468581}};
  for (const auto &row : expected)
    {
      unsigned int i       = 1;
      const double lateral = 1. / std::sqrt(row[0]);
      relax(stretches(row[0], lateral, lateral), [&](const Tensor<2, 3> &tau) {
        EXPECT_NEAR(tau[0][0] - tau[1][1], row[i++], 3e-7);
      });
    }
}

TEST(exp2, is_of_second_order_at_finite_strain)
{
  EXPECT_NEAR(observed_order(ViscousUpdate::exp2, 20), 2., .03);
  EXPECT_NEAR(observed_order(ViscousUpdate::exp2, 80), 2., .03);
}

TEST(backward_euler_and_lin, are_of_first_order_at_finite_strain)
{
  EXPECT_NEAR(observed_order(ViscousUpdate::be, 80), 1., .03);
  EXPECT_NEAR(observed_order(ViscousUpdate::lin, 80), 1., .1);
}

// Errors of the ramp listed in theory A.2 for 10 steps, two digits.
TEST(every_update, has_the_error_that_theory_lists)
{
  const double reference = .5774801429;
  const auto   error     = [&](const ViscousUpdate update) {
    return stress_after_ramp(update, 10) - reference;
  };
  EXPECT_NEAR(error(ViscousUpdate::exp2), -3.6e-4, .05e-4);
  EXPECT_NEAR(error(ViscousUpdate::be), -2.0e-2, .05e-2);
  EXPECT_NEAR(error(ViscousUpdate::lin), 6.0e-4, .05e-4);
}

// Linear viscoelasticity: a ramp to gamma in t gives
// tau_12 = mu gamma (1 - exp(-t/tau)) tau/t, whatever the step.
TEST(exp2_and_lin, are_exact_in_one_step_at_small_strain)
{
  const double gamma = 1e-5;
  for (const ViscousUpdate update : {ViscousUpdate::exp2, ViscousUpdate::lin})
    for (const double t : {1e-6, 4e-3, 6e-3, 1., 20.})
      {
        Point point(bare_branch(update));
        point.move_to(simple_shear(gamma), t);
        EXPECT_NEAR(point.kirchhoff(simple_shear(gamma))[0][1] / gamma,
                    -std::expm1(-t) / t,
                    1e-9);
        // The energy lost in that ramp is the integral of mu/tau x^2 with
        // x = gamma tau/t (1 - exp(-s/tau)).
        const double lost =
          gamma * gamma / (t * t) *
          (t + 2. * std::expm1(-t) - .5 * std::expm1(-2. * t));
        EXPECT_NEAR(point.response.dissipated / (gamma * gamma),
                    lost / (gamma * gamma),
                    1e-8);
      }
}

TEST(a_step_without_time, leaves_the_dashpots_rigid)
{
  std::mt19937 generator(11);
  for (const ViscousUpdate update : all_updates)
    {
      Point point(bare_branch(update));
      point.move_to(random_gradient(generator, .3), .7);
      const std::vector<double> before = point.history;
      const double              stored = point.response.stored;
      point.move_to(random_gradient(generator, .3), 0.);
      EXPECT_NE(point.response.stored, stored);
      EXPECT_EQ(point.response.dissipated, 0.);
      for (unsigned int i = 6; i < 12; ++i)
        EXPECT_NEAR(point.history[i], before[i], 1e-15);
    }
}

TEST(a_very_short_step, tends_to_rigid_dashpots)
{
  const auto F = simple_shear(.8);
  for (const ViscousUpdate update : all_updates)
    {
      Point rigid(bare_branch(update)), fast(bare_branch(update));
      rigid.move_to(F, 0.);
      fast.move_to(F, 1e-9);
      EXPECT_LT((fast.response.S - rigid.response.S).norm(), 1e-8);
    }
}

TEST(a_very_long_step, relaxes_the_branches_entirely)
{
  const auto F = simple_shear(.8);
  for (const ViscousUpdate update : all_updates)
    for (const double dt : {1e9, 1e300})
      {
        Point point(bare_branch(update));
        point.move_to(F, 0.);
        point.move_to(F, dt);
        EXPECT_LT(point.response.S.norm(), 1e-8);
        EXPECT_LT(point.response.stored, 1e-12);
      }
}

TEST(branches, keep_the_inelastic_metric_unimodular)
{
  std::mt19937 generator(5);
  Point        point(bare_branch(ViscousUpdate::exp2));
  for (unsigned int i = 0; i < 100; ++i)
    point.move_to(random_gradient(generator, .3), .1);
  Six Ci;
  std::copy(point.history.begin() + 6, point.history.end(), Ci.begin());
  EXPECT_NEAR(determinant(Ci, adjugate(Ci)), 1., 1e-13);
}

TEST(branches, do_not_answer_a_change_of_volume)
{
  Point point(bare_branch(ViscousUpdate::exp2));
  point.move_to(stretches(1.1, 1.1, 1.1), .1);
  EXPECT_LT(point.response.S.norm(), 1e-14);
}

TEST(instantaneous_constants, add_the_branches_to_the_shear_modulus)
{
  RubberLaw law;
  law.elastic  = MooneyRivlin{50., .4, .1};
  law.branches = {{.3, 1.}, {.2, 2.}};
  EXPECT_EQ(law.n_history(), 18u);
  EXPECT_DOUBLE_EQ(law.shear_modulus_instantaneous(), 1.);
  // E = 9 K G/(3 K + G), nu = E/(2 G) - 1
  const double K = 50. + .2 + 1. / 3.;
  EXPECT_NEAR(law.young_instantaneous(), 9. * K / (3. * K + 1.), 1e-12);
  EXPECT_NEAR(law.poisson_instantaneous(),
              law.young_instantaneous() / 2. - 1.,
              1e-12);
}

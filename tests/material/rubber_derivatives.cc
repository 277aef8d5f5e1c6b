// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress is the derivative of energy and the tangent that of stress.
#include "random_deformation.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace demold;

namespace
{
  RubberLaw law_of(const bool isochoric, const Variant &variant)
  {
    RubberLaw law;
    if (isochoric)
      law.elastic = IsochoricMooneyRivlin{.3, .1, 40.};
    else
      law.elastic = MooneyRivlin{50., .4, .1};
    law.branches   = {{.3, .01}, {.5, .2}, {.2, 5.}};
    law.update     = variant.update;
    law.branch_law = variant.branch_law;
    return law;
  }

  /// Calls f(law, C, dt, history) over laws, variants, strains and steps, the
  /// history being that of three random steps.
  template <typename F>
  void everywhere(const F &f)
  {
    std::mt19937 generator(20);
    for (const bool isochoric : {false, true})
      for (const Variant &variant : all_variants)
        for (const double dt : {0., 1e-3, .1, 30.})
          {
            Point point(law_of(isochoric, variant));
            for (unsigned int step = 0; step < 3; ++step)
              point.move_to(random_gradient(generator, .25), .05);
            f(point.law,
              right_cauchy_green(random_gradient(generator, .25)),
              dt,
              point.history);
          }
  }

  BulkResponse answer(const RubberLaw             &law,
                      const SymmetricTensor<2, 3> &C,
                      const double                 dt,
                      const std::vector<double>   &history)
  {
    std::vector<double> trial(history.size());
    BulkResponse        response;
    law.evaluate(C, dt, history.data(), trial.data(), true, response);
    return response;
  }

  /// Central difference of f in the symmetric direction (i, j): df/dC_ij, for
  /// i != j the mean of df/dC_ij and df/dC_ji.
  template <typename F>
  auto difference(const F &f, SymmetricTensor<2, 3> C, int i, int j)
  {
    const double h = 1e-5;
    C[i][j] += h;
    const auto plus = f(C);
    C[i][j] -= 2. * h;
    const auto minus = f(C);
    return (plus - minus) / ((i == j ? 2. : 4.) * h);
  }
} // namespace

// With rigid dashpots (dt = 0) the branches are elastic too; those of the
// stress convolution store nothing that one would know of.
TEST(rubber_stress, is_twice_the_derivative_of_the_stored_energy)
{
  everywhere(
    [](const auto &law, const auto &C, double dt, const auto &history) {
      if (dt > 0. || law.branch_law == BranchLaw::convolution)
        return;
      const auto S      = answer(law, C, dt, history).S;
      const auto stored = [&](const auto &C) {
        return answer(law, C, dt, history).stored;
      };
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = i; j < 3; ++j)
          EXPECT_NEAR(2. * difference(stored, C, i, j),
                      S[i][j],
                      1e-7 * S.norm());
    });
}

TEST(rubber_tangent, matches_differences_of_the_stress)
{
  everywhere(
    [](const auto &law, const auto &C, double dt, const auto &history) {
      const auto D      = answer(law, C, dt, history).dS_dE;
      const auto stress = [&](const auto &C) {
        return answer(law, C, dt, history).S;
      };
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int l = k; l < 3; ++l)
          {
            const SymmetricTensor<2, 3> column =
              2. * difference(stress, C, k, l);
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int j = i; j < 3; ++j)
                EXPECT_NEAR(column[i][j], D[i][j][k][l], 1e-6 * D.norm())
                  << i << j << k << l << " at dt = " << dt;
          }
    });
}

// The branches hide behind the bulk stiffness above; alone they cannot.
TEST(rubber_tangent, of_a_branch_alone_matches_differences)
{
  std::mt19937 generator(7);
  for (const Variant &variant : all_variants)
    for (const double dt : {0., .3, 3.})
      {
        Point point(bare_branch(variant));
        point.move_to(random_gradient(generator, .3), .5);
        const auto C      = right_cauchy_green(random_gradient(generator, .3));
        const auto D      = answer(point.law, C, dt, point.history).dS_dE;
        const auto stress = [&](const auto &C) {
          return answer(point.law, C, dt, point.history).S;
        };
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = k; l < 3; ++l)
            {
              const SymmetricTensor<2, 3> column =
                2. * difference(stress, C, k, l);
              for (unsigned int i = 0; i < 3; ++i)
                for (unsigned int j = i; j < 3; ++j)
                  EXPECT_NEAR(column[i][j], D[i][j][k][l], 1e-7 * D.norm())
                    << variant.name;
            }
      }
}

TEST(rubber_tangent, has_major_symmetry)
{
  everywhere(
    [](const auto &law, const auto &C, double dt, const auto &history) {
      const auto D = answer(law, C, dt, history).dS_dE;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int k = 0; k < 3; ++k)
            for (unsigned int l = 0; l < 3; ++l)
              EXPECT_NEAR(D[i][j][k][l], D[k][l][i][j], 1e-14 * D.norm());
    });
}

TEST(rubber_stress, is_the_same_with_and_without_tangent_and_energies)
{
  everywhere(
    [](const auto &law, const auto &C, double dt, const auto &history) {
      std::vector<double> trial(history.size());
      BulkResponse        response;
      law.evaluate(C, dt, history.data(), trial.data(), false, response);
      const BulkResponse full = answer(law, C, dt, history);
      EXPECT_EQ(response.S, full.S);
      EXPECT_EQ(response.stored, full.stored);
      EXPECT_EQ(response.dissipated, full.dissipated);

      BulkResponse stress_alone;
      law.evaluate(C,
                   dt,
                   history.data(),
                   trial.data(),
                   false,
                   stress_alone,
                   false);
      EXPECT_EQ(stress_alone.S, full.S);
      EXPECT_EQ(stress_alone.stored, 0.);
    });
}

// A random rotation in each step: C is the same, and so must be all else.
TEST(rubber_stress, turns_with_the_body)
{
  std::mt19937                           generator(3);
  std::uniform_real_distribution<double> angle(-M_PI, M_PI);
  const auto                             rotation = [&]() {
    const double       a = angle(generator), b = angle(generator);
    const Tensor<2, 3> around_z({{std::cos(a), -std::sin(a), 0.},
                                 {std::sin(a), std::cos(a), 0.},
                                 {0., 0., 1.}});
    const Tensor<2, 3> around_x({{1., 0., 0.},
                                 {0., std::cos(b), -std::sin(b)},
                                 {0., std::sin(b), std::cos(b)}});
    return around_z * around_x;
  };

  for (const Variant &variant : all_variants)
    {
      Point still(law_of(false, variant)), turned(still.law);
      for (unsigned int step = 0; step < 6; ++step)
        {
          const auto         F = random_gradient(generator, .2);
          const Tensor<2, 3> Q = rotation();
          still.move_to(F, .1);
          turned.move_to(Q * F, .1);

          const Tensor<2, 3> tau = still.kirchhoff(F);
          EXPECT_LT((turned.response.S - still.response.S).norm(),
                    1e-12 * still.response.S.norm())
            << variant.name;
          EXPECT_LT((turned.kirchhoff(Q * F) - Q * tau * transpose(Q)).norm(),
                    1e-12 * tau.norm());
          EXPECT_LT((turned.response.dS_dE - still.response.dS_dE).norm(),
                    1e-12 * still.response.dS_dE.norm());
          EXPECT_NEAR(turned.response.stored, still.response.stored, 1e-12);
          EXPECT_NEAR(turned.response.dissipated,
                      still.response.dissipated,
                      1e-12);
        }
    }
}

TEST(rubber_at_rest, is_free_of_stress_and_energy_for_any_step)
{
  for (const Variant &variant : all_variants)
    for (const double dt : {0., 1., 1e9})
      {
        Point point(law_of(true, variant));
        point.move_to(stretches(1., 1., 1.), dt);
        EXPECT_LT(point.response.S.norm(), 1e-13);
        EXPECT_LT(point.response.stored, 1e-30);
        EXPECT_LT(std::abs(point.response.dissipated), 1e-30);
      }
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Every branch law has the right fast and slow limits.
#include "random_deformation.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace demold;

TEST(all_branch_laws, give_the_equilibrium_response_after_a_step_of_1e9_tau)
{
  std::mt19937 generator(8);
  for (const Variant &variant : all_variants)
    {
      RubberLaw law = bare_branch(variant);
      law.elastic   = MooneyRivlin{50., .4, .1};
      RubberLaw elastic(law);
      elastic.branches.clear();

      Point point(law), reference(elastic);
      point.move_to(random_gradient(generator, .3), .7);
      const auto F = random_gradient(generator, .3);
      point.move_to(F, 0.);
      for (const double dt : {1e9, 1e300})
        {
          const auto &now      = point.move_to(F, dt);
          const auto &expected = reference.move_to(F, dt);
          EXPECT_LT((now.S - expected.S).norm(), 1e-8) << variant.name;
          EXPECT_NEAR(now.stored, expected.stored, 1e-12) << variant.name;
          EXPECT_TRUE(std::isfinite(now.dissipated)) << variant.name;
          EXPECT_LT((now.dS_dE - expected.dS_dE).norm(), 1e-7) << variant.name;
        }
    }
}

TEST(all_branch_laws, give_the_instantaneous_response_in_a_step_of_1e_12_tau)
{
  std::mt19937 generator(8);
  for (const Variant &variant : all_variants)
    {
      Point fast(bare_branch(variant));
      fast.move_to(random_gradient(generator, .3), .7);
      Point      rigid = fast;
      const auto F     = random_gradient(generator, .3);
      fast.move_to(F, 1e-12);
      rigid.move_to(F, 0.);
      EXPECT_LT((fast.response.S - rigid.response.S).norm(), 1e-11)
        << variant.name;
      EXPECT_LT((fast.response.dS_dE - rigid.response.dS_dE).norm(),
                1e-11 * rigid.response.dS_dE.norm())
        << variant.name;
      EXPECT_NEAR(fast.response.stored, rigid.response.stored, 1e-11);
      if (variant.branch_law != BranchLaw::convolution)
        {
          EXPECT_GE(fast.response.dissipated, 0.);
          EXPECT_LT(fast.response.dissipated, 1e-11);
        }
    }
}

// Rigid dashpots: the stress is that of the spring, dev(b_bar) or b - 1.
TEST(all_branch_laws, answer_a_jump_with_their_spring)
{
  std::mt19937       generator(2);
  const auto         F = random_gradient(generator, .4);
  const Tensor<2, 3> one(dealii::unit_symmetric_tensor<3>());
  const Tensor<2, 3> b     = F * transpose(F);
  const Tensor<2, 3> b_bar = b * std::pow(determinant(F), -2. / 3.);
  for (const Variant &variant : all_variants)
    {
      Point point(bare_branch(variant));
      point.move_to(F, 0.);
      const bool volumetric = variant.branch_law == BranchLaw::linear ||
                              variant.branch_law == BranchLaw::lubliner;
      const Tensor<2, 3> tau =
        volumetric ? b - one : b_bar - trace(b_bar) / 3. * one;
      EXPECT_LT((point.kirchhoff(F) - tau).norm(), 1e-14) << variant.name;
    }
}

// The small-strain constants against the stress of a small jump.
TEST(instantaneous_constants, count_what_the_branch_adds_to_the_bulk)
{
  const double e = 1e-6;
  for (const Variant &variant : all_variants)
    {
      RubberLaw law = bare_branch(variant);
      law.elastic   = MooneyRivlin{50., .4, .1};
      Point sheared(law), swollen(law);
      sheared.move_to(simple_shear(e), 0.);
      EXPECT_NEAR(sheared.response.S[0][1] / e,
                  law.shear_modulus_instantaneous(),
                  1e-4)
        << variant.name;
      swollen.move_to(stretches(1. + e, 1. + e, 1. + e), 0.);
      EXPECT_NEAR(swollen.response.S[0][0] / (3. * e),
                  law.bulk_modulus_instantaneous(),
                  1e-3)
        << variant.name;
    }
}

// The elastic law is in C10 and C01 already; the branches take its shape.
TEST(stress_convolution, scales_the_isochoric_elastic_stress)
{
  std::mt19937 generator(6);
  const auto   F = random_gradient(generator, .4);
  RubberLaw    law;
  law.elastic    = IsochoricMooneyRivlin{.3, .2, 40.};
  law.branches   = {{.5, .1}, {1.5, 10.}};
  law.branch_law = BranchLaw::convolution;
  RubberLaw stiffer(law);
  stiffer.branches.clear();
  stiffer.elastic = IsochoricMooneyRivlin{.9, .6, 40.}; // 1 + sum of g_j = 3

  Point point(law), expected(stiffer);
  point.move_to(F, 0.);
  expected.move_to(F, 0.);
  EXPECT_LT((point.response.S - expected.response.S).norm(), 1e-13);
  EXPECT_LT((point.response.dS_dE - expected.response.dS_dE).norm(), 1e-12);
}

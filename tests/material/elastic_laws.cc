// SPDX-License-Identifier: LGPL-2.1-or-later
// The elastic laws answer with their reference values and their potential.
#include "random_deformation.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace demold;

namespace
{
  // The constants of the reference values, theory A.1.
  RubberLaw reference_law()
  {
    RubberLaw law;
    law.elastic = MooneyRivlin{50., .4, .1};
    return law;
  }

  BulkResponse answer(const RubberLaw &law, const SymmetricTensor<2, 3> &C)
  {
    BulkResponse response;
    law.evaluate(C, 0., nullptr, nullptr, true, response);
    return response;
  }

  /// Nominal stress P = F S of a diagonal F.
  SymmetricTensor<2, 3> nominal(const Tensor<2, 3> &F)
  {
    const auto            S = answer(reference_law(), right_cauchy_green(F)).S;
    SymmetricTensor<2, 3> P;
    for (unsigned int i = 0; i < 3; ++i)
      P[i][i] = F[i][i] * S[i][i];
    return P;
  }

  /// The lateral stretch that leaves the sides free, by bisection.
  double free_lateral_stretch(const double stretch)
  {
    double low = .5, high = 1.5;
    while (high - low > 1e-14)
      {
        const double middle = .5 * (low + high);
        if (nominal(stretches(stretch, middle, middle))[1][1] > 0.)
          high = middle;
        else
          low = middle;
      }
    return .5 * (low + high);
  }
} // namespace

// Expected values: theory A.1, Lambda = 50, mu1 = 0.4, mu2 = 0.1 MPa.
TEST(mooney_rivlin, has_the_reference_values_of_free_uniaxial_tension)
{
  const double expected[4][3] = {{.8, 1.11653439, -.39785933},
                                 {1.2, .91356683, .24390404},
                                 {1.5, .81761696, .49221603},
                                 {2., .70833002, .78741328}};
  for (const auto &[stretch, lateral, P] : expected)
    {
      const double computed = free_lateral_stretch(stretch);
      EXPECT_NEAR(computed, lateral, 6e-9);
      EXPECT_NEAR(nominal(stretches(stretch, computed, computed))[0][0],
                  P,
                  1e-8);
    }
}

TEST(mooney_rivlin, has_the_reference_values_of_confined_compression)
{
  const double expected[4][3] = {{.98, -1.03444898, -1.01424490},
                                 {.99, -.51458586, -.50453535},
                                 {1.01, .50946535, .49951485},
                                 {1.05, 2.49904762, 2.45023810}};
  for (const auto &[stretch, P, lateral_cauchy] : expected)
    {
      const auto computed = nominal(stretches(stretch, 1., 1.));
      EXPECT_NEAR(computed[0][0], P, 1e-8);
      EXPECT_NEAR(computed[1][1] / stretch, lateral_cauchy, 1e-8);
    }
}

TEST(mooney_rivlin, has_the_reference_values_of_simple_shear)
{
  const auto         F     = simple_shear(.5);
  const auto         S     = answer(reference_law(), right_cauchy_green(F)).S;
  const Tensor<2, 3> sigma = F * Tensor<2, 3>(S) * transpose(F);
  EXPECT_NEAR(sigma[0][0], .125, 1e-14);
  EXPECT_NEAR(sigma[0][1], .25, 1e-14);
  EXPECT_NEAR(sigma[1][1], 0., 1e-14);
  EXPECT_NEAR(sigma[2][2], .025, 1e-14);
}

TEST(mooney_rivlin, has_the_small_strain_constants_of_theory)
{
  const RubberLaw law = reference_law();
  EXPECT_NEAR(law.young_relaxed(), 1.495069034, 1e-9);
  EXPECT_NEAR(law.poisson_relaxed(), .495069, 1e-6);
  EXPECT_NEAR(law.bulk_modulus(), 50.53333, 1e-5);
  EXPECT_DOUBLE_EQ(law.shear_modulus_relaxed(), .5);
  EXPECT_EQ(law.n_history(), 0u);
}

// Tangent at C = 1 is (K - 2/3 G) 1x1 + 2 G I by definition of K and G.
TEST(both_elastic_laws, start_with_their_small_strain_constants)
{
  for (const bool isochoric : {false, true})
    {
      RubberLaw law = reference_law();
      if (isochoric)
        law.elastic = IsochoricMooneyRivlin{.3, .1, 40.};
      const auto   D = answer(law, dealii::unit_symmetric_tensor<3>()).dS_dE;
      const double K = isochoric ? 40. : 50. + .2 + 1. / 3.;
      const double G = isochoric ? 2. * (.3 + .1) : .5;
      EXPECT_DOUBLE_EQ(law.bulk_modulus(), K);
      EXPECT_DOUBLE_EQ(law.shear_modulus_relaxed(), G);
      const auto I = dealii::identity_tensor<3>();
      const auto E = dealii::outer_product(dealii::unit_symmetric_tensor<3>(),
                                           dealii::unit_symmetric_tensor<3>());
      EXPECT_LT((D - (K - 2. / 3. * G) * E - 2. * G * I).norm(), 1e-12 * K);
    }
}

// mu1 = 2 C10, mu2 = 2 C01, Lambda = K - 2 mu2 - 2/3 (mu1+mu2): theory A.1.
TEST(both_elastic_laws, agree_to_first_order_in_strain)
{
  RubberLaw isochoric = reference_law();
  isochoric.elastic   = IsochoricMooneyRivlin{.2, .05, 50. + .2 + 1. / 3.};
  std::mt19937 generator(1);
  const auto   H = random_gradient(generator, 1.) -
                 Tensor<2, 3>(dealii::unit_symmetric_tensor<3>());
  std::vector<double> difference;
  for (const double size : {1e-3, 1e-4})
    {
      const Tensor<2, 3> F =
        Tensor<2, 3>(dealii::unit_symmetric_tensor<3>()) + size * H;
      const auto C = right_cauchy_green(F);
      difference.push_back(
        (answer(reference_law(), C).S - answer(isochoric, C).S).norm());
    }
  EXPECT_NEAR(difference[0] / difference[1], 100., 2.);
}

TEST(isochoric_law, does_not_change_pressure_in_a_pure_change_of_shape)
{
  RubberLaw law;
  law.elastic  = IsochoricMooneyRivlin{.3, .1, 40.};
  const auto F = stretches(1.5, 1. / 1.2, 1.2 / 1.5);
  const auto S = answer(law, right_cauchy_green(F)).S;
  EXPECT_NEAR(trace(F * Tensor<2, 3>(S) * transpose(F)), 0., 1e-13);
}

TEST(isochoric_law, answers_a_change_of_volume_by_the_bulk_modulus_alone)
{
  RubberLaw law;
  law.elastic    = IsochoricMooneyRivlin{.3, .1, 40.};
  const auto   F = stretches(1.1, 1.1, 1.1);
  const auto   S = answer(law, right_cauchy_green(F)).S;
  const double J = 1.1 * 1.1 * 1.1;
  // sigma = K (J-1) 1
  EXPECT_NEAR(1.1 * 1.1 * S[0][0] / J, 40. * (J - 1.), 1e-12);
  EXPECT_NEAR(S[0][1], 0., 1e-14);
  EXPECT_NEAR(answer(law, right_cauchy_green(F)).stored,
              20. * (J - 1.) * (J - 1.),
              1e-12);
}

// W = E : D : E / 2 to leading order, so W keeps its digits at tiny strain.
TEST(both_elastic_laws, keep_the_digits_of_the_energy_at_tiny_strain)
{
  for (const bool isochoric : {false, true})
    {
      RubberLaw law = reference_law();
      if (isochoric)
        law.elastic = IsochoricMooneyRivlin{.3, .1, 40.};
      const double          gamma = 1e-6;
      SymmetricTensor<2, 3> C     = dealii::unit_symmetric_tensor<3>();
      C[0][1]                     = gamma;
      EXPECT_NEAR(answer(law, C).stored /
                    (.5 * law.shear_modulus_relaxed() * gamma * gamma),
                  1.,
                  1e-4);
    }
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// The mean stress and stretch of an element are those of its forces and its
// deformation.
#include "distorted_element.h"
#include "test_rubber.h"

#include <gtest/gtest.h>

using namespace demold;

namespace
{
  /// In equilibrium with the nodal forces r_a: v mean(sigma) = sum r_a x_a.
  template <int dim, int n_nodes>
  void check_mean_stress(const VolumeTreatment volume)
  {
    const auto   X = element_nodes<dim, n_nodes>(false);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> wobble(-.1, .1);
    double                                 u[dim * n_nodes];
    for (double &v : u)
      v = wobble(random);
    DistortedElement<dim, n_nodes> element(test_rubber(), volume);
    ElementResult<dim, n_nodes>    result;
    ASSERT_TRUE(element.evaluate(u, result));

    double volume_now = 0.;
    for (const auto &point : element.points)
      {
        Matrix3 F = {{{{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}}};
        for (int a = 0; a < n_nodes; ++a)
          for (int i = 0; i < dim; ++i)
            for (int j = 0; j < dim; ++j)
              F[i][j] += u[a * dim + i] * point.gradient[a][j];
        volume_now += determinant(F) * point.weight;
      }
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        {
          double sum = 0.;
          for (int a = 0; a < n_nodes; ++a)
            sum += result.residual[a * dim + i] * (X[a][j] + u[a * dim + j]);
          EXPECT_NEAR(result.stress[voigt_index[i][j]] * volume_now,
                      sum,
                      1e-12 * std::abs(sum) + 1e-12);
        }
  }
} // namespace

TEST(ElementMeans, mean_stress_is_that_of_the_nodal_forces)
{
  check_mean_stress<2, 4>(VolumeTreatment::pointwise);
  check_mean_stress<3, 8>(VolumeTreatment::pointwise);
}

TEST(ElementMeans, mean_stress_with_mean_dilatation_is_that_of_the_nodal_forces)
{
  check_mean_stress<2, 4>(VolumeTreatment::mean_dilatation);
  check_mean_stress<3, 8>(VolumeTreatment::mean_dilatation);
}

// Theory A.1: simple shear g = 0.5 of Lambda = 50, mu1 = 0.4, mu2 = 0.1 MPa
// gives s11 = 0.125, s12 = 0.25, s22 = 0, s33 = 0.025 MPa.
TEST(ElementMeans, means_of_simple_shear_are_the_closed_form)
{
  const double g     = .5;
  const auto   X     = element_nodes<3, 8>(false);
  double       u[24] = {};
  for (int a = 0; a < 8; ++a)
    u[3 * a] = g * X[a][1];
  for (const auto volume :
       {VolumeTreatment::pointwise, VolumeTreatment::mean_dilatation})
    {
      DistortedElement<3, 8> element(test_rubber(), volume);
      ElementResult<3, 8>    result;
      ASSERT_TRUE(element.evaluate(u, result));
      const Voigt stress = {{.125, 0., .025, .25, 0., 0.}};
      const Voigt C      = {{1., 1. + g * g, 1., g, 0., 0.}};
      for (unsigned int I = 0; I < 6; ++I)
        {
          EXPECT_NEAR(result.stress[I], stress[I], 1e-13) << I;
          EXPECT_NEAR(result.C[I], C[I], 1e-13) << I;
        }
    }
}

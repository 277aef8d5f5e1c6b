// SPDX-License-Identifier: LGPL-2.1-or-later
// Element residual is the gradient of the stored energy, the tangent that of
// the residual, for every element and plane model; the means are those of
// stress and stretch.
#include "solid/element_kernel.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

using namespace demold;

namespace
{
  /// Nodes of a distorted bilinear or trilinear element with 2^dim nodes.
  template <int dim, int n_nodes>
  std::array<std::array<double, dim>, n_nodes> element_nodes(const bool hoop)
  {
    static_assert(n_nodes == (1 << dim), "linear elements");
    std::mt19937                                 random(7);
    std::uniform_real_distribution<double>       wobble(-.1, .1);
    std::array<std::array<double, dim>, n_nodes> X;
    for (int a = 0; a < n_nodes; ++a)
      for (int d = 0; d < dim; ++d)
        X[a][d] = ((a >> d) & 1) * (1. + .2 * d) + wobble(random) +
                  (hoop && d == 0 ? 1.5 : 0.);
    return X;
  }

  /// Its quadrature points.
  template <int dim, int n_nodes>
  std::vector<ElementPoint<dim, n_nodes>> element_points(const bool hoop)
  {
    const auto X = element_nodes<dim, n_nodes>(hoop);
    std::vector<ElementPoint<dim, n_nodes>> points;
    const double                            g = .5 / std::sqrt(3.);
    for (int q = 0; q < n_nodes; ++q)
      {
        double xi[dim], dN[n_nodes][dim], N[n_nodes];
        for (int d = 0; d < dim; ++d)
          xi[d] = .5 + (((q >> d) & 1) ? g : -g);
        for (int a = 0; a < n_nodes; ++a)
          {
            N[a] = 1.;
            for (int d = 0; d < dim; ++d)
              N[a] *= ((a >> d) & 1) ? xi[d] : 1. - xi[d];
            for (int d = 0; d < dim; ++d)
              {
                dN[a][d] = ((a >> d) & 1) ? 1. : -1.;
                for (int e = 0; e < dim; ++e)
                  if (e != d)
                    dN[a][d] *= ((a >> e) & 1) ? xi[e] : 1. - xi[e];
              }
          }
        Matrix3 jacobian = {};
        if (dim == 2)
          jacobian[2][2] = 1.;
        double radius = 0.;
        for (int a = 0; a < n_nodes; ++a)
          {
            radius += N[a] * X[a][0];
            for (int i = 0; i < dim; ++i)
              for (int j = 0; j < dim; ++j)
                jacobian[i][j] += X[a][i] * dN[a][j];
          }
        const double               J = determinant(jacobian);
        const Matrix3              G = inverse(jacobian, J);
        ElementPoint<dim, n_nodes> point;
        point.weight = J / std::pow(2., dim) * (hoop ? 2. * M_PI * radius : 1.);
        for (int a = 0; a < n_nodes; ++a)
          {
            point.hoop[a] = hoop ? N[a] / radius : 0.;
            for (int j = 0; j < dim; ++j)
              {
                point.gradient[a][j] = 0.;
                for (int k = 0; k < dim; ++k)
                  point.gradient[a][j] += dN[a][k] * G[k][j];
              }
          }
        points.push_back(point);
      }
    return points;
  }

  RubberLaw rubber(const bool viscous)
  {
    RubberLaw    law;
    MooneyRivlin elastic;
    elastic.lambda = 50.;
    elastic.mu1    = .4;
    elastic.mu2    = .1;
    law.elastic    = elastic;
    if (viscous)
      {
        MaxwellBranch branch;
        branch.modulus         = .3;
        branch.relaxation_time = .1;
        law.branches.push_back(branch);
      }
    return law;
  }

  template <int dim, int n_nodes>
  void check_derivatives(const VolumeTreatment volume, const bool hoop)
  {
    constexpr int n      = dim * n_nodes;
    const auto    points = element_points<dim, n_nodes>(hoop);
    for (const bool viscous : {false, true})
      {
        const RubberLaw     law = rubber(viscous);
        std::vector<double> history(law.n_history() * points.size());
        std::vector<double> unused(history);
        for (std::size_t q = 0; viscous && q < points.size(); ++q)
          law.initialize(history.data() + q * law.n_history());

        std::mt19937                           random(3);
        std::uniform_real_distribution<double> displacement(-.15, .15);
        double                                 u[n];
        for (double &entry : u)
          entry = displacement(random);

        ElementKernel<dim, n_nodes> kernel;
        ElementResult<dim, n_nodes> result, plus, minus;
        const auto evaluate = [&](ElementResult<dim, n_nodes> &out) {
          ASSERT_TRUE(kernel.evaluate(points,
                                      u,
                                      &law,
                                      0,
                                      volume,
                                      .05,
                                      history.data(),
                                      unused.data(),
                                      true,
                                      out));
        };
        evaluate(result);
        double largest = 0.;
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j)
            largest = std::max(largest, std::abs(result.tangent[i][j]));
        for (int j = 0; j < n; ++j)
          {
            const double h = 1e-5, old = u[j];
            u[j] = old + h;
            evaluate(plus);
            u[j] = old - h;
            evaluate(minus);
            u[j] = old;
            if (!viscous) // the elastic residual has a potential
              {
                EXPECT_NEAR((plus.stored - minus.stored) / (2. * h),
                            result.residual[j],
                            1e-6 * largest);
              }
            for (int i = 0; i < n; ++i)
              {
                EXPECT_NEAR((plus.residual[i] - minus.residual[i]) / (2. * h),
                            result.tangent[i][j],
                            1e-6 * largest);
                EXPECT_NEAR(result.tangent[i][j],
                            result.tangent[j][i],
                            1e-12 * largest);
              }
          }
      }
  }

  /// In equilibrium with the nodal forces r_a: v mean(sigma) = sum r_a x_a.
  template <int dim, int n_nodes>
  void check_mean_stress(const VolumeTreatment volume)
  {
    const auto      X      = element_nodes<dim, n_nodes>(false);
    const auto      points = element_points<dim, n_nodes>(false);
    const RubberLaw law    = rubber(false);
    std::mt19937    random(3);
    std::uniform_real_distribution<double> wobble(-.1, .1);
    double                                 u[dim * n_nodes];
    for (double &v : u)
      v = wobble(random);
    ElementKernel<dim, n_nodes> kernel;
    ElementResult<dim, n_nodes> result;
    ASSERT_TRUE(kernel.evaluate(points,
                                u,
                                &law,
                                0,
                                volume,
                                1.,
                                nullptr,
                                nullptr,
                                false,
                                result));

    double volume_now = 0.;
    for (const auto &point : points)
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

TEST(ElementKernel, q1_tangent_matches_differences_in_plane_strain)
{
  check_derivatives<2, 4>(VolumeTreatment::pointwise, false);
}

TEST(ElementKernel, q1p0_tangent_matches_differences_in_plane_strain)
{
  check_derivatives<2, 4>(VolumeTreatment::mean_dilatation, false);
}

TEST(ElementKernel, q1_tangent_matches_differences_axisymmetric)
{
  check_derivatives<2, 4>(VolumeTreatment::pointwise, true);
}

TEST(ElementKernel, q1p0_tangent_matches_differences_axisymmetric)
{
  check_derivatives<2, 4>(VolumeTreatment::mean_dilatation, true);
}

TEST(ElementKernel, q1_tangent_matches_differences_in_space)
{
  check_derivatives<3, 8>(VolumeTreatment::pointwise, false);
}

TEST(ElementKernel, q1p0_tangent_matches_differences_in_space)
{
  check_derivatives<3, 8>(VolumeTreatment::mean_dilatation, false);
}

TEST(ElementKernel, refuses_an_element_turned_inside_out)
{
  const auto          points = element_points<2, 4>(false);
  const RubberLaw     law    = rubber(false);
  ElementKernel<2, 4> kernel;
  ElementResult<2, 4> result;
  const double        u[8] = {3., 0., 0., 0., 3., 0., 0., 0.};
  EXPECT_FALSE(kernel.evaluate(points,
                               u,
                               &law,
                               0,
                               VolumeTreatment::pointwise,
                               1.,
                               nullptr,
                               nullptr,
                               true,
                               result));
}

TEST(ElementKernel, mean_stress_is_that_of_the_nodal_forces)
{
  check_mean_stress<2, 4>(VolumeTreatment::pointwise);
  check_mean_stress<3, 8>(VolumeTreatment::pointwise);
}

TEST(ElementKernel,
     mean_stress_with_mean_dilatation_is_that_of_the_nodal_forces)
{
  check_mean_stress<2, 4>(VolumeTreatment::mean_dilatation);
  check_mean_stress<3, 8>(VolumeTreatment::mean_dilatation);
}

// Theory A.1: simple shear g = 0.5 of Lambda = 50, mu1 = 0.4, mu2 = 0.1 MPa
// gives s11 = 0.125, s12 = 0.25, s22 = 0, s33 = 0.025 MPa.
TEST(ElementKernel, means_of_simple_shear_are_the_closed_form)
{
  RubberLaw law;
  law.elastic        = MooneyRivlin{50., .4, .1};
  const double g     = .5;
  const auto   X     = element_nodes<3, 8>(false);
  double       u[24] = {};
  for (int a = 0; a < 8; ++a)
    u[3 * a] = g * X[a][1];
  ElementKernel<3, 8> kernel;
  ElementResult<3, 8> result;
  for (const auto volume :
       {VolumeTreatment::pointwise, VolumeTreatment::mean_dilatation})
    {
      ASSERT_TRUE(kernel.evaluate(element_points<3, 8>(false),
                                  u,
                                  &law,
                                  0,
                                  volume,
                                  1.,
                                  nullptr,
                                  nullptr,
                                  false,
                                  result));
      const Voigt stress = {{.125, 0., .025, .25, 0., 0.}};
      const Voigt C      = {{1., 1. + g * g, 1., g, 0., 0.}};
      for (unsigned int I = 0; I < 6; ++I)
        {
          EXPECT_NEAR(result.stress[I], stress[I], 1e-13) << I;
          EXPECT_NEAR(result.C[I], C[I], 1e-13) << I;
        }
    }
}

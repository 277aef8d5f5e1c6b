// SPDX-License-Identifier: LGPL-2.1-or-later
// Element residual is the gradient of the stored energy, the tangent that of
// the residual, for every element and plane model.
#include "distorted_element.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace demold;

namespace
{
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

// SPDX-License-Identifier: LGPL-2.1-or-later
// Element residual is the gradient of the stored energy, the tangent that of
// the residual, for every element and plane model.
#include "distorted_element.h"
#include "test_rubber.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace demold;

namespace
{
  template <int dim, int n_nodes>
  void check_derivatives(const VolumeTreatment volume, const bool hoop)
  {
    constexpr int n = dim * n_nodes;
    for (const bool viscous : {false, true})
      {
        DistortedElement<dim, n_nodes> element(viscous ?
                                                 test_rubber({{.3, .1}}) :
                                                 test_rubber(),
                                               volume,
                                               hoop);
        std::mt19937                           random(3);
        std::uniform_real_distribution<double> displacement(-.15, .15);
        double                                 u[n];
        for (double &entry : u)
          entry = displacement(random);

        ElementResult<dim, n_nodes> result, plus, minus;
        const auto evaluate = [&](ElementResult<dim, n_nodes> &out) {
          ASSERT_TRUE(element.evaluate(u, out));
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
  DistortedElement<2, 4> element(test_rubber(), VolumeTreatment::pointwise);
  ElementResult<2, 4>    result;
  const double           u[8] = {3., 0., 0., 0., 3., 0., 0., 0.};
  EXPECT_FALSE(element.evaluate(u, result));
}

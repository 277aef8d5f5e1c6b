// SPDX-License-Identifier: LGPL-2.1-or-later
// A distorted element with 2^dim nodes of rubber, for tests of the kernel.
#ifndef demold_tests_distorted_element_h
#define demold_tests_distorted_element_h

#include "solid/element_kernel.h"

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace demold
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

  /// The distorted element of one rubber, at the first step from rest.
  template <int dim, int n_nodes>
  struct DistortedElement
  {
    DistortedElement(const RubberLaw      &law,
                     const VolumeTreatment volume,
                     const bool            hoop = false)
      : law(law)
      , volume(volume)
      , points(element_points<dim, n_nodes>(hoop))
      , history(law.n_history() * points.size())
      , new_history(history)
    {
      for (std::size_t q = 0; law.n_history() > 0 && q < points.size(); ++q)
        law.initialize(history.data() + q * law.n_history());
    }

    /// Sums at nodal displacements @p u [mm], unknown a*dim + i; false if the
    /// element is inside out.
    bool evaluate(const double *u, ElementResult<dim, n_nodes> &result)
    {
      const double dt = .05; // [s], half a relaxation time of the tests
      return kernel.evaluate(points,
                             u,
                             &law,
                             0,
                             volume,
                             dt,
                             history.data(),
                             new_history.data(),
                             true,
                             result);
    }

    const RubberLaw                               law;
    const VolumeTreatment                         volume;
    const std::vector<ElementPoint<dim, n_nodes>> points;
    std::vector<double>                           history, new_history;
    ElementKernel<dim, n_nodes>                   kernel;
  };
} // namespace demold

#endif

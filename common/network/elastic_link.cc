// SPDX-License-Identifier: LGPL-2.1-or-later
// Springs and bars: elements of a few unknowns with a stored energy.
#include "network/elastic_link.h"

namespace demold
{
  using namespace dealii;

  LinkResponse Spring::response(const std::vector<double> &u) const
  {
    const double e = u[1] - u[0];
    LinkResponse r{.5 * stiffness * e * e,
                   dealii::Vector<double>(2),
                   FullMatrix<double>(2, 2)};
    for (const unsigned int i : {0, 1})
      {
        const double sign_i = i == 0 ? -1. : 1.;
        r.R(i)              = sign_i * stiffness * e;
        for (const unsigned int j : {0, 1})
          r.K(i, j) = sign_i * (j == 0 ? -1. : 1.) * stiffness;
      }
    return r;
  }

  LinkResponse Bar::response(const std::vector<double> &u) const
  {
    const Tensor<1, 2> X = b - a;
    Tensor<1, 2>       x = X;
    for (const unsigned int d : {0, 1})
      x[d] += u[2 + d] - u[d];
    const double L2 = X.norm_square(), L = X.norm();
    const double strain = (x.norm_square() - L2) / (2. * L2);
    LinkResponse r{.5 * EA * L * strain * strain,
                   dealii::Vector<double>(4),
                   FullMatrix<double>(4, 4)};
    // dE/dx = x/L^2, d2E/dx2 = 1/L^2
    for (unsigned int i = 0; i < 4; ++i)
      {
        const double sign_i = i < 2 ? -1. : 1.;
        r.R(i)              = sign_i * EA * strain * x[i % 2] / L;
        for (unsigned int j = 0; j < 4; ++j)
          r.K(i, j) = sign_i * (j < 2 ? -1. : 1.) * EA *
                      (x[i % 2] * x[j % 2] / (L2 * L) +
                       (i % 2 == j % 2 ? strain / L : 0.));
      }
    return r;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Symmetric 3 x 3 matrices as six plain numbers, for the laws' inner loops.
#ifndef demold_material_symmetric_six_h
#define demold_material_symmetric_six_h

#include <array>

namespace demold
{
  /// A symmetric 3 x 3 matrix as its entries 00, 11, 22, 01, 02, 12: the order
  /// in which dealii::SymmetricTensor<2,3> stores them.
  using Six = std::array<double, 6>;

  /// Any 3 x 3 matrix, row by row.
  using Nine = std::array<double, 9>;

  constexpr Six six_identity = {{1., 1., 1., 0., 0., 0.}};

  /// a : b
  inline double contract(const Six &a, const Six &b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] +
           2. * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
  }

  /// det(a) a^-1
  inline Six adjugate(const Six &a)
  {
    return {{a[1] * a[2] - a[5] * a[5],
             a[0] * a[2] - a[4] * a[4],
             a[0] * a[1] - a[3] * a[3],
             a[4] * a[5] - a[3] * a[2],
             a[3] * a[5] - a[4] * a[1],
             a[3] * a[4] - a[0] * a[5]}};
  }

  /// det(a) from a and its adjugate.
  inline double determinant(const Six &a, const Six &adjugate_of_a)
  {
    return a[0] * adjugate_of_a[0] + a[3] * adjugate_of_a[3] +
           a[4] * adjugate_of_a[4];
  }

  /// a^-1
  inline Six inverse(const Six &a)
  {
    const Six    adj = adjugate(a);
    const double f   = 1. / determinant(a, adj);
    return {
      {f * adj[0], f * adj[1], f * adj[2], f * adj[3], f * adj[4], f * adj[5]}};
  }

  /// a - b
  inline Six difference(const Six &a, const Six &b)
  {
    return {{a[0] - b[0],
             a[1] - b[1],
             a[2] - b[2],
             a[3] - b[3],
             a[4] - b[4],
             a[5] - b[5]}};
  }

  /// s a
  inline Six scaled(const Six &a, const double s)
  {
    return {{s * a[0], s * a[1], s * a[2], s * a[3], s * a[4], s * a[5]}};
  }

  /// y += s x
  inline void add_scaled(Six &y, const double s, const Six &x)
  {
    for (unsigned int i = 0; i < 6; ++i)
      y[i] += s * x[i];
  }

  /// The matrix product a b.
  inline Nine product(const Six &a, const Six &b)
  {
    return {{a[0] * b[0] + a[3] * b[3] + a[4] * b[4],
             a[0] * b[3] + a[3] * b[1] + a[4] * b[5],
             a[0] * b[4] + a[3] * b[5] + a[4] * b[2],
             a[3] * b[0] + a[1] * b[3] + a[5] * b[4],
             a[3] * b[3] + a[1] * b[1] + a[5] * b[5],
             a[3] * b[4] + a[1] * b[5] + a[5] * b[2],
             a[4] * b[0] + a[5] * b[3] + a[2] * b[4],
             a[4] * b[3] + a[5] * b[1] + a[2] * b[5],
             a[4] * b[4] + a[5] * b[5] + a[2] * b[2]}};
  }

  /// g p, where the caller knows the product to be symmetric.
  inline Six symmetric_product(const Six &g, const Nine &p)
  {
    return {{g[0] * p[0] + g[3] * p[3] + g[4] * p[6],
             g[3] * p[1] + g[1] * p[4] + g[5] * p[7],
             g[4] * p[2] + g[5] * p[5] + g[2] * p[8],
             g[0] * p[1] + g[3] * p[4] + g[4] * p[7],
             g[0] * p[2] + g[3] * p[5] + g[4] * p[8],
             g[3] * p[2] + g[1] * p[5] + g[5] * p[8]}};
  }

  /// tr(a b)
  inline double trace_of_product(const Nine &a, const Nine &b)
  {
    return a[0] * b[0] + a[4] * b[4] + a[8] * b[8] + a[1] * b[3] + a[3] * b[1] +
           a[2] * b[6] + a[6] * b[2] + a[5] * b[7] + a[7] * b[5];
  }

  /// det(a)
  inline double determinant(const Nine &a)
  {
    return a[0] * (a[4] * a[8] - a[5] * a[7]) -
           a[1] * (a[3] * a[8] - a[5] * a[6]) +
           a[2] * (a[3] * a[7] - a[4] * a[6]);
  }
} // namespace demold

#endif

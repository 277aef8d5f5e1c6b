// SPDX-License-Identifier: LGPL-2.1-or-later
// Kinematics of a point and the assembly of its tangent from parts.
#include "material/response_sums.h"

#include <cmath>

namespace demold
{
  namespace
  {
    /// T += f X(.)X in the upper triangle.
    void add_square(const Six &X, const double f, double T[6][6])
    {
      const double x0 = f * X[0], x1 = f * X[1], x3 = f * X[3];
      const double x4 = f * X[4], x5 = f * X[5];

      T[0][0] += x0 * X[0];
      T[0][1] += x3 * X[3];
      T[0][2] += x4 * X[4];
      T[0][3] += x0 * X[3];
      T[0][4] += x0 * X[4];
      T[0][5] += x3 * X[4];
      T[1][1] += x1 * X[1];
      T[1][2] += x5 * X[5];
      T[1][3] += x1 * X[3];
      T[1][4] += x3 * X[5];
      T[1][5] += x1 * X[5];
      T[2][2] += f * X[2] * X[2];
      T[2][3] += x4 * X[5];
      T[2][4] += x4 * X[2];
      T[2][5] += x5 * X[2];
      T[3][3] += .5 * (x0 * X[1] + x3 * X[3]);
      T[3][4] += .5 * (x0 * X[5] + x3 * X[4]);
      T[3][5] += .5 * (x3 * X[5] + x1 * X[4]);
      T[4][4] += .5 * (x0 * X[2] + x4 * X[4]);
      T[4][5] += .5 * (x3 * X[2] + x4 * X[5]);
      T[5][5] += .5 * (x1 * X[2] + x5 * X[5]);
    }

    /// T += a XxX in the upper triangle.
    void add_product(const Six &X, const double a, double T[6][6])
    {
      for (unsigned int i = 0; i < 6; ++i)
        {
          const double aX = a * X[i];
          for (unsigned int j = i; j < 6; ++j)
            T[i][j] += aX * X[j];
        }
    }
  } // namespace

  Deformation::Deformation(const Six &C)
    : C(C)
  {
    Six A = C;
    for (unsigned int i = 0; i < 3; ++i)
      A[i] -= 1.;
    const Six    adj_A = adjugate(A);
    const double tr    = A[0] + A[1] + A[2];
    const double II    = adj_A[0] + adj_A[1] + adj_A[2];

    I1_excess = tr;
    I2_excess = 2. * tr + II;
    JJ_excess = tr + II + determinant(A, adj_A);
    J         = std::sqrt(1. + JJ_excess);
    log_JJ    = std::log1p(JJ_excess);
    p_excess  = std::expm1(-log_JJ / 3.);
    p         = 1. + p_excess;
    K         = scaled(adjugate(C), 1. / (1. + JJ_excess));
  }

  void ResponseSums::add_rest(const Six   &G,
                              const double product,
                              const double square)
  {
    add_product(G, product, rest);
    add_square(G, square, rest);
  }

  void ResponseSums::write_tangent(const Six &K, double *tangent) const
  {
    double T[6][6];
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = i; j < 6; ++j)
        T[i][j] = rest[i][j] + U[i] * K[j] + K[i] * U[j];
    add_product(K, KK, T);
    add_square(K, K_square, T);

    T[0][1] += one;
    T[0][2] += one;
    T[1][2] += one;
    for (unsigned int i = 3; i < 6; ++i)
      T[i][i] -= .5 * one;

    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = i; j < 6; ++j)
        tangent[6 * i + j] = tangent[6 * j + i] = T[i][j];
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Symmetric tensors as six numbers, for element kernels.
#ifndef demold_solid_voigt_h
#define demold_solid_voigt_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>

namespace demold
{
  /// Components in the order 11, 22, 33, 12, 13, 23 (deal.II's own order).
  using Voigt = std::array<double, 6>;

  /// Fourth-order tensor with minor symmetries over the same order.
  using VoigtMatrix = std::array<std::array<double, 6>, 6>;

  /// 3 x 3 matrix without ceremony.
  using Matrix3 = std::array<std::array<double, 3>, 3>;

  constexpr std::array<std::array<unsigned int, 2>, 6> voigt_pairs = {
    {{{0, 0}}, {{1, 1}}, {{2, 2}}, {{0, 1}}, {{0, 2}}, {{1, 2}}}};

  constexpr unsigned int voigt_index[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};

  inline double determinant(const Matrix3 &F)
  {
    return F[0][0] * (F[1][1] * F[2][2] - F[1][2] * F[2][1]) -
           F[0][1] * (F[1][0] * F[2][2] - F[1][2] * F[2][0]) +
           F[0][2] * (F[1][0] * F[2][1] - F[1][1] * F[2][0]);
  }

  /// Inverse of @p F, whose determinant is @p J.
  inline Matrix3 inverse(const Matrix3 &F, const double J)
  {
    const double s = 1. / J;
    Matrix3      G;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          const unsigned int a = (j + 1) % 3, b = (j + 2) % 3;
          const unsigned int c = (i + 1) % 3, d = (i + 2) % 3;
          G[i][j] = s * (F[a][c] * F[b][d] - F[a][d] * F[b][c]);
        }
    return G;
  }

  /// The map S -> F S F^T on six numbers.
  inline VoigtMatrix push_forward_map(const Matrix3 &F)
  {
    VoigtMatrix T;
    for (unsigned int I = 0; I < 6; ++I)
      for (unsigned int K = 0; K < 6; ++K)
        {
          const unsigned int i = voigt_pairs[I][0], j = voigt_pairs[I][1];
          const unsigned int k = voigt_pairs[K][0], l = voigt_pairs[K][1];
          T[I][K] = F[i][k] * F[j][l];
          if (k != l)
            T[I][K] += F[i][l] * F[j][k];
        }
    return T;
  }

  /// Six numbers of a symmetric tensor.
  inline Voigt to_voigt(const dealii::SymmetricTensor<2, 3> &S)
  {
    Voigt v;
    for (unsigned int I = 0; I < 6; ++I)
      v[I] = S.access_raw_entry(I);
    return v;
  }

  /// T C T^T, where C is the raw storage of a tangent.
  inline VoigtMatrix push_forward(const VoigtMatrix                   &T,
                                  const dealii::SymmetricTensor<4, 3> &C)
  {
    VoigtMatrix c, TC, result;
    for (unsigned int I = 0; I < 6; ++I)
      for (unsigned int K = 0; K < 6; ++K)
        c[I][K] = C(dealii::TableIndices<4>(voigt_pairs[I][0],
                                            voigt_pairs[I][1],
                                            voigt_pairs[K][0],
                                            voigt_pairs[K][1]));
    for (unsigned int I = 0; I < 6; ++I)
      for (unsigned int K = 0; K < 6; ++K)
        {
          double sum = 0.;
          for (unsigned int M = 0; M < 6; ++M)
            sum += T[I][M] * c[M][K];
          TC[I][K] = sum;
        }
    for (unsigned int I = 0; I < 6; ++I)
      for (unsigned int K = I; K < 6; ++K)
        {
          double sum = 0.;
          for (unsigned int M = 0; M < 6; ++M)
            sum += TC[I][M] * T[K][M];
          result[I][K] = result[K][I] = sum;
        }
    return result;
  }
} // namespace demold

#endif

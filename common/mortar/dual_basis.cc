// SPDX-License-Identifier: LGPL-2.1-or-later
// Dual multiplier shape functions of a slave face, also partly covered.
#include "mortar/dual_basis.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  namespace
  {
    NodeMatrix<double> identity(const unsigned int n)
    {
      NodeMatrix<double> one{};
      for (unsigned int i = 0; i < n; ++i)
        one[i][i] = 1.;
      return one;
    }

    NodeMatrix<double> product(const NodeMatrix<double> &a,
                               const NodeMatrix<double> &b)
    {
      NodeMatrix<double> c{};
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int k = 0; k < 4; ++k)
          for (unsigned int j = 0; j < 4; ++j)
            c[i][j] += a[i][k] * b[k][j];
      return c;
    }

    /// Largest sum of a column's magnitudes.
    double norm(const NodeMatrix<double> &a)
    {
      double largest = 0.;
      for (unsigned int j = 0; j < 4; ++j)
        {
          double sum = 0.;
          for (unsigned int i = 0; i < 4; ++i)
            sum += std::abs(a[i][j]);
          largest = std::max(largest, sum);
        }
      return largest;
    }

    /// Inverse of a symmetric positive definite matrix by Gauss and Jordan;
    /// false if a pivot vanishes.
    bool invert(NodeMatrix<double>  a,
                const unsigned int  n,
                NodeMatrix<double> &inverse)
    {
      inverse = identity(n);
      for (unsigned int k = 0; k < n; ++k)
        {
          if (!(a[k][k] > 1e-14))
            return false;
          const double pivot = 1. / a[k][k];
          for (unsigned int j = 0; j < n; ++j)
            {
              a[k][j] *= pivot;
              inverse[k][j] *= pivot;
            }
          for (unsigned int i = 0; i < n; ++i)
            if (i != k)
              {
                const double factor = a[i][k];
                for (unsigned int j = 0; j < n; ++j)
                  {
                    a[i][j] -= factor * a[k][j];
                    inverse[i][j] -= factor * inverse[k][j];
                  }
              }
        }
      return true;
    }
  } // namespace

  std::array<double, 4> dual_D(const NodeMatrix<double> &D,
                               const unsigned int        n_nodes)
  {
    std::array<double, 4> result{};
    for (unsigned int A = 0; A < n_nodes; ++A)
      for (unsigned int B = 0; B < n_nodes; ++B)
        result[A] += D[A][B];
    return result;
  }

  DualBasis dual_basis(const NodeMatrix<double> &D, const unsigned int n_nodes)
  {
    DualBasis basis;
    basis.n_nodes = n_nodes;
    basis.A       = identity(n_nodes);

    std::array<double, 4> scale{};
    for (unsigned int A = 0; A < n_nodes; ++A)
      {
        if (!(D[A][A] > 0.))
          return basis;
        scale[A] = 1. / std::sqrt(D[A][A]);
      }
    NodeMatrix<double> scaled{}, inverse{};
    for (unsigned int A = 0; A < n_nodes; ++A)
      for (unsigned int B = 0; B < n_nodes; ++B)
        scaled[A][B] = scale[A] * D[A][B] * scale[B];
    if (!invert(scaled, n_nodes, inverse) ||
        norm(scaled) * norm(inverse) > worst_dual_condition)
      return basis;

    const std::array<double, 4> diagonal = dual_D(D, n_nodes);
    for (unsigned int A = 0; A < n_nodes; ++A)
      for (unsigned int B = 0; B < n_nodes; ++B)
        {
          basis.inverse[A][B] = scale[A] * inverse[A][B] * scale[B];
          basis.A[A][B]       = diagonal[A] * basis.inverse[A][B];
        }
    basis.lumped = false;
    return basis;
  }

  NodeMatrix<double> dual_basis_change(const DualBasis          &basis,
                                       const NodeMatrix<double> &dD)
  {
    if (basis.lumped)
      return {};
    NodeMatrix<double>          change   = product(basis.A, dD);
    const std::array<double, 4> diagonal = dual_D(dD, basis.n_nodes);
    for (unsigned int A = 0; A < 4; ++A)
      for (unsigned int B = 0; B < 4; ++B)
        change[A][B] = (A == B ? diagonal[A] : 0.) - change[A][B];
    return product(change, basis.inverse);
  }

  NodeMatrix<double> dual_M(const DualBasis &basis, const NodeMatrix<double> &M)
  {
    return product(basis.A, M);
  }

  NodeMatrix<double> dual_M_change(const DualBasis          &basis,
                                   const NodeMatrix<double> &dA,
                                   const NodeMatrix<double> &M,
                                   const NodeMatrix<double> &dM)
  {
    NodeMatrix<double>       result = product(dA, M);
    const NodeMatrix<double> other  = product(basis.A, dM);
    for (unsigned int A = 0; A < 4; ++A)
      for (unsigned int C = 0; C < 4; ++C)
        result[A][C] += other[A][C];
    return result;
  }
} // namespace demold

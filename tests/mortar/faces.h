// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces for the tests of the mortar geometry.
#ifndef demold_tests_mortar_faces_h
#define demold_tests_mortar_faces_h

#include "mortar/pair_integrals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace mortar_tests
{
  using namespace demold;
  using dealii::Point;
  using dealii::Tensor;

  using Corners = std::array<std::array<double, 3>, 4>;

  inline FacetPositions quad(const Corners &x)
  {
    FacetPositions face;
    face.n_nodes = 4;
    for (unsigned int i = 0; i < 4; ++i)
      face.x[i] = Point<3>(x[i][0], x[i][1], x[i][2]);
    return face;
  }

  inline FacetPositions
  line(const double x0, const double y0, const double x1, const double y1)
  {
    FacetPositions face;
    face.n_nodes = 2;
    face.x[0]    = Point<3>(x0, y0, 0.);
    face.x[1]    = Point<3>(x1, y1, 0.);
    return face;
  }

  /// Seen from the other side: nodes in reverse.
  inline FacetPositions reversed(const FacetPositions &face)
  {
    FacetPositions result = face;
    for (unsigned int i = 0; i < face.n_nodes; ++i)
      result.x[i] = face.x[face.n_nodes - 1 - i];
    return result;
  }

  inline FacetPositions moved(const FacetPositions &face,
                              const Tensor<1, 3>   &shift)
  {
    FacetPositions result = face;
    for (unsigned int i = 0; i < face.n_nodes; ++i)
      result.x[i] += shift;
    return result;
  }

  inline Tensor<1, 3> vector(const double x, const double y, const double z)
  {
    return Point<3>(x, y, z);
  }

  // The slave of all tables: unit square, normal e_z. The masters look down.
  inline FacetPositions unit_square()
  {
    return quad(
      {{{{0., 0., 0.}}, {{1., 0., 0.}}, {{1., 1., 0.}}, {{0., 1., 0.}}}});
  }

  /// Theory B.12, T1: turned by 45 degree, half-diagonal 0.6.
  inline FacetPositions master_T1()
  {
    return quad(
      {{{{1.1, .5, .1}}, {{.5, -.1, .1}}, {{-.1, .5, .1}}, {{.5, 1.1, .1}}}});
  }

  /// Theory B.12, T2: shifted.
  inline FacetPositions master_T2()
  {
    return moved(reversed(unit_square()), vector(.3, .2, .05));
  }

  /// Theory B.12, T3: full cover, exactly aligned.
  inline FacetPositions master_T3()
  {
    return moved(reversed(unit_square()), vector(0., 0., .05));
  }

  struct Random
  {
    std::mt19937 engine;

    explicit Random(const unsigned int seed = 20140711)
      : engine(seed)
    {}

    double operator()(const double low, const double high)
    {
      return low + (high - low) * (double(engine()) / 4294967296.);
    }

    Tensor<1, 3> vector(const double size)
    {
      const double x = (*this)(-size, size), y = (*this)(-size, size),
                   z = (*this)(-size, size);
      return Point<3>(x, y, z);
    }

    FacetPositions shaken(const FacetPositions &face, const double size)
    {
      FacetPositions result = face;
      for (unsigned int i = 0; i < face.n_nodes; ++i)
        {
          result.x[i] += vector(size);
          if (face.n_nodes == 2)
            result.x[i][2] = 0.;
        }
      return result;
    }

    /// A rotation with a random axis and angle.
    Tensor<2, 3> rotation()
    {
      Tensor<1, 3> axis  = vector(1.);
      const double angle = (*this)(0., 3.);
      axis /= axis.norm() > 0. ? axis.norm() : 1.;
      Tensor<2, 3> R;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          R[i][j] = (i == j ? std::cos(angle) : 0.) +
                    (1. - std::cos(angle)) * axis[i] * axis[j];
      for (unsigned int i = 0; i < 3; ++i)
        {
          const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
          R[j][i] += std::sin(angle) * axis[k];
          R[i][j] -= std::sin(angle) * axis[k];
        }
      return R;
    }
  };

  inline FacetPositions turned(const FacetPositions &face,
                               const Tensor<2, 3>   &R,
                               const double          scale,
                               const Tensor<1, 3>   &shift)
  {
    FacetPositions result = face;
    for (unsigned int i = 0; i < face.n_nodes; ++i)
      result.x[i] = Point<3>(scale * (R * Tensor<1, 3>(face.x[i])) + shift);
    return result;
  }

  inline double row_sum(const NodeMatrix<double> &a, const unsigned int A)
  {
    return a[A][0] + a[A][1] + a[A][2] + a[A][3];
  }

  /// Half the cross product of the diagonals: the area of a quadrilateral as
  /// seen along its normal at the centre.
  inline double projected_area(const FacetPositions &face)
  {
    return 0.5 * cross_product_3d(face.x[2] - face.x[0], face.x[3] - face.x[1])
                   .norm();
  }
} // namespace mortar_tests

#endif

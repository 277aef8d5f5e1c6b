// SPDX-License-Identifier: LGPL-2.1-or-later
// The plane through the slave centre in which a pair is intersected.
#ifndef demold_mortar_auxiliary_plane_h
#define demold_mortar_auxiliary_plane_h

#include "mortar/plane_vector.h"

#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>

namespace demold
{
  /// Auxiliary plane of a slave face (theory B.2): through its centre x_10,
  /// normal to its normal n_10 there. In 2-D it is the slave line itself, and
  /// e_0 its direction.
  template <typename Number>
  struct AuxiliaryPlane
  {
    using Vector = dealii::Tensor<1, 3, Number>;

    Vector                centre; ///< x_10 [mm]
    std::array<Vector, 2> a;      ///< a_1, a_2 at the centre [mm]
    Number                size;   ///< |a_1 x a_2| [mm^2], in 2-D [mm]
    Vector                normal; ///< n_10
    std::array<Vector, 2> e;      ///< orthonormal base vectors of the plane
  };

  // deal.II's products of tensors do not know every number.

  template <typename Number>
  Number product(const dealii::Tensor<1, 3, Number> &u,
                 const dealii::Tensor<1, 3, Number> &v)
  {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  }

  template <typename Number>
  dealii::Tensor<1, 3, Number>
  cross_product(const dealii::Tensor<1, 3, Number> &u,
                const dealii::Tensor<1, 3, Number> &v)
  {
    dealii::Tensor<1, 3, Number> w;
    for (unsigned int i = 0; i < 3; ++i)
      w[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
    return w;
  }

  /// Derivatives of the shape functions of a face at its centre.
  inline double centre_slope(const unsigned int n_nodes,
                             const unsigned int node,
                             const unsigned int direction)
  {
    constexpr std::array<std::array<double, 2>, 4> corner{
      {{{-1., -1.}}, {{1., -1.}}, {{1., 1.}}, {{-1., 1.}}}};
    if (n_nodes == 2)
      return direction == 0 ? 0.5 * corner[node][0] : 0.;
    return 0.25 * corner[node][direction];
  }

  /// The plane of a slave face. Only centre, a and size are set if the face
  /// has no area, size = 0.
  template <typename Number>
  AuxiliaryPlane<Number>
  auxiliary_plane(const std::array<dealii::Tensor<1, 3, Number>, 4> &x,
                  const unsigned int                                 n_nodes)
  {
    using std::sqrt;
    AuxiliaryPlane<Number> plane;
    plane.size = 0.;
    for (unsigned int c = 0; c < 3; ++c)
      plane.centre[c] = plane.a[0][c] = plane.a[1][c] = 0.;
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int c = 0; c < 3; ++c)
        {
          plane.centre[c] += x[i][c] / double(n_nodes);
          plane.a[0][c] += centre_slope(n_nodes, i, 0) * x[i][c];
          plane.a[1][c] += centre_slope(n_nodes, i, 1) * x[i][c];
        }
    if (n_nodes == 2)
      plane.a[1][2] = 1.;

    plane.normal             = cross_product(plane.a[0], plane.a[1]);
    const Number size_square = product(plane.normal, plane.normal);
    if (!(value_of(size_square) > 0.))
      return plane;
    plane.size          = sqrt(size_square);
    const Number length = sqrt(product(plane.a[0], plane.a[0]));
    for (unsigned int c = 0; c < 3; ++c)
      {
        plane.normal[c] /= plane.size;
        plane.e[0][c] = plane.a[0][c] / length;
      }
    plane.e[1] = cross_product(plane.normal, plane.e[0]);
    return plane;
  }

  /// Coordinates [mm] of the projections of the nodes of a face.
  template <typename Number>
  PlaneNodes<Number>
  projected(const AuxiliaryPlane<Number>                      &plane,
            const std::array<dealii::Tensor<1, 3, Number>, 4> &x,
            const unsigned int                                 n_nodes)
  {
    PlaneNodes<Number> y;
    for (unsigned int i = 0; i < n_nodes; ++i)
      {
        dealii::Tensor<1, 3, Number> d;
        for (unsigned int c = 0; c < 3; ++c)
          d[c] = x[i][c] - plane.centre[c];
        y[i][0] = product(d, plane.e[0]);
        y[i][1] = product(d, plane.e[1]);
      }
    return y;
  }
} // namespace demold

#endif

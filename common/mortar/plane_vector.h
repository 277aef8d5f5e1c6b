// SPDX-License-Identifier: LGPL-2.1-or-later
// Vectors in the auxiliary plane, of numbers with or without derivatives.
#ifndef demold_mortar_plane_vector_h
#define demold_mortar_plane_vector_h

#include <array>

namespace demold
{
  /// Coordinates in the auxiliary plane [mm].
  template <typename Number>
  using PlaneVector = std::array<Number, 2>;

  /// Those of the nodes of a face; in 2-D two nodes with one coordinate each.
  template <typename Number>
  using PlaneNodes = std::array<PlaneVector<Number>, 4>;

  inline double value_of(const double number)
  {
    return number;
  }

  /// The value of a number that carries derivatives.
  template <typename Number>
  double value_of(const Number &number)
  {
    return number.val();
  }

  template <typename Number>
  PlaneVector<double> value_of(const PlaneVector<Number> &v)
  {
    return {{value_of(v[0]), value_of(v[1])}};
  }

  template <typename Number>
  PlaneNodes<double> value_of(const PlaneNodes<Number> &y)
  {
    return {{value_of(y[0]), value_of(y[1]), value_of(y[2]), value_of(y[3])}};
  }

  template <typename Number>
  PlaneVector<Number> difference(const PlaneVector<Number> &u,
                                 const PlaneVector<Number> &v)
  {
    return {{u[0] - v[0], u[1] - v[1]}};
  }

  template <typename Number>
  Number cross(const PlaneVector<Number> &u, const PlaneVector<Number> &v)
  {
    return u[0] * v[1] - u[1] * v[0];
  }

  template <typename Number>
  Number dot(const PlaneVector<Number> &u, const PlaneVector<Number> &v)
  {
    return u[0] * v[0] + u[1] * v[1];
  }
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Integrals over a segment and their derivatives by coordinates in the plane.
#ifndef demold_mortar_segment_gradients_h
#define demold_mortar_segment_gradients_h

#include "mortar/quadrature_rules.h"
#include "mortar/segment_3d.h"

#include <array>

namespace demold
{
  /// One number per integral of a pair, so that the innermost loops run over
  /// integrals: the upper triangle of D, M row by row, the area, and one left
  /// over.
  using IntegralRow = std::array<double, 28>;

  constexpr unsigned int n_D_integrals = 10;
  constexpr unsigned int area_integral = 26;

  /// Place of D_AB in an IntegralRow.
  constexpr unsigned int D_integral(const unsigned int A, const unsigned int B)
  {
    constexpr unsigned int place[4][4]{{0, 1, 2, 3},
                                       {1, 4, 5, 6},
                                       {2, 5, 7, 8},
                                       {3, 6, 8, 9}};
    return place[A][B];
  }

  /// Place of M_AC in an IntegralRow.
  constexpr unsigned int M_integral(const unsigned int A, const unsigned int C)
  {
    return n_D_integrals + 4 * A + C;
  }

  /// Integrals of a pair [mm^2] and their derivatives [mm] by the coordinates
  /// of the projected nodes of the slave (0 to 3) and the master (4 to 7).
  struct PlaneGradients
  {
    IntegralRow                             value{};
    std::array<PlaneVector<IntegralRow>, 8> nodes{};
  };

  /// Adds what add_segment() of pair_integrals.templates.h computes, with its
  /// derivatives (theory B.10). At a Gauss point y of weight W = w det
  ///
  ///     d(W f) = w f d det + W grad f_slave.(dy - sum N_I dx_I)
  ///                        + W grad f_master.(dy - sum N_J dx_J),
  ///
  /// as the parameters of a point change by those of its velocity relative to
  /// the face. What hangs on centre and vertices is collected there first and
  /// carried to the nodes once per segment.
  void add_segment_gradients(const Segment3d          &segment,
                             const PlaneNodes<double> &slave,
                             const PlaneNodes<double> &master,
                             const TriangleRule       &rule,
                             PlaneGradients           &sums);
} // namespace demold

#endif

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
  /// integrals: the first three columns of M, then the upper triangle of D. The
  /// rest follows from sum_C M_AC = sum_B D_AB and area = sum_AB D_AB.
  using IntegralRow = std::array<double, 22>;

  constexpr unsigned int n_M_integrals = 12;

  /// Place of M_AC, C < 3, in an IntegralRow.
  constexpr unsigned int M_integral(const unsigned int A, const unsigned int C)
  {
    return 3 * A + C;
  }

  /// Place of D_AB in an IntegralRow.
  constexpr unsigned int D_integral(const unsigned int A, const unsigned int B)
  {
    constexpr unsigned int place[4][4]{{0, 1, 2, 3},
                                       {1, 4, 5, 6},
                                       {2, 5, 7, 8},
                                       {3, 6, 8, 9}};
    return n_M_integrals + place[A][B];
  }

  /// Integrals of a pair [mm^2] and their derivatives [mm] by the coordinates
  /// of the projected nodes of the slave (0 to 3) and the master (4 to 6).
  /// Those by the last node of the master are minus the sum of the others: the
  /// integrals do not change if all points shift.
  struct PlaneGradients
  {
    IntegralRow                             value{};
    std::array<PlaneVector<IntegralRow>, 7> nodes{};
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

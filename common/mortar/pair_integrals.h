// SPDX-License-Identifier: LGPL-2.1-or-later
// Mortar integrals over the part a slave and a master face have in common.
#ifndef demold_mortar_pair_integrals_h
#define demold_mortar_pair_integrals_h

#include "base/plane_model.h"
#include "contact/facet.h"

#include <deal.II/base/tensor.h>

#include <array>

namespace demold
{
  /// Current positions [mm] of the nodes of a face, in the order of Facet.
  template <typename Number>
  using FaceNodes = std::array<dealii::Tensor<1, 3, Number>, 4>;

  /// One row and one column per node of a face; 2-D uses the first two.
  template <typename Number>
  using NodeMatrix = std::array<std::array<Number, 4>, 4>;

  /// How a pair of faces is integrated.
  struct PairOptions
  {
    /// Gauss points per triangle of a segment: 3, 6 or 7, exact to degree 2, 4
    /// and 5. The integrands are polynomials, of degree 4, if both faces are
    /// parallelograms when seen along the slave normal.
    unsigned int triangle_points = 7;
    /// Gauss points per segment in 2-D, 1 to 4. Two are exact, also in an
    /// axisymmetric body.
    unsigned int line_points = 3;
    /// 2-D only: thickness, or 2 pi R at the current radius of the slave.
    PlaneModel plane;
  };

  /// Integrals over the common part of two faces, measured in the auxiliary
  /// plane of the slave face (theory B.2, B.6 with standard multipliers):
  ///
  ///     D_AB = int N_A N_B,   M_AC = int N_A N_C,   A, B slave, C master.
  ///
  /// Both row sums are int N_A. In 2-D the thickness is included.
  template <typename Number>
  struct PairIntegrals
  {
    NodeMatrix<Number> D{};  ///< [mm^2] symmetric
    NodeMatrix<Number> M{};  ///< [mm^2]
    Number             area; ///< [mm^2] of the common part, 0 without one
    bool               overlaps = false; ///< false: all entries are zero

    PairIntegrals()
      : area(0.)
    {}
  };

  /// Integrates a pair of faces of @p n_nodes nodes each (2 or 4). Whether they
  /// face one another, and whether they are near, is left to the caller: they
  /// are seen along the slave normal, from either side. All decisions, among
  /// them the shape of the segments, are taken on values; what is computed with
  /// @p Number carries exact derivatives within one shape. Numbers other than
  /// double: pair_integrals.templates.h.
  template <typename Number>
  PairIntegrals<Number> integrate_pair(const FaceNodes<Number> &slave,
                                       const FaceNodes<Number> &master,
                                       const unsigned int       n_nodes,
                                       const PairOptions       &options);

  /// The nodes of a facet as the integrals take them.
  FaceNodes<double> face_nodes(const FacetPositions &facet);

  /// The same for facets as contact knows them.
  PairIntegrals<double> integrate_pair(const FacetPositions &slave,
                                       const FacetPositions &master,
                                       const PairOptions    &options);
} // namespace demold

#endif

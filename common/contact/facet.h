// SPDX-License-Identifier: LGPL-2.1-or-later
// One facet of a contact surface: bilinear face in 3-D, line in 2-D.
#ifndef demold_contact_facet_h
#define demold_contact_facet_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace demold
{
  /// Node numbers of a facet of a contact surface.
  ///
  /// 3-D: four nodes, counter-clockwise seen from outside the body (NOT the
  /// lexicographic order of deal.II), at the parameters (-1,-1), (1,-1),
  /// (1,1), (-1,1). 2-D: two nodes in the x-y plane at -1 and 1, ordered such
  /// that the body lies to the left; the line is read as a facet extruded
  /// along e_z, with e_z as its second base vector and without curvature. In
  /// both cases the outward normal is a_1 x a_2 / |a_1 x a_2|.
  struct Facet
  {
    std::array<unsigned int, 4> nodes;
    unsigned int                n_nodes; ///< 2 or 4
  };

  /// Current positions of the nodes of one facet [mm].
  struct FacetPositions
  {
    std::array<dealii::Point<3>, 4> x;
    unsigned int                    n_nodes; ///< 2 or 4
  };

  /// Parameters xi^1, xi^2 on a facet, inside within [-1,1]; xi^2 = 0 in 2-D.
  using FacetCoordinates = std::array<double, 2>;

  /// Shape functions of a facet, thesis (3.1), and their derivatives. The
  /// only second derivative of a bilinear function is the mixed one.
  struct FacetShape
  {
    std::array<double, 4>                N{};
    std::array<std::array<double, 2>, 4> dN{};
    std::array<double, 4>                d2N{};
  };

  inline FacetShape facet_shape(const unsigned int      n_nodes,
                                const FacetCoordinates &xi)
  {
    constexpr std::array<std::array<double, 2>, 4> corner{
      {{{-1., -1.}}, {{1., -1.}}, {{1., 1.}}, {{-1., 1.}}}};
    FacetShape shape;
    for (unsigned int i = 0; i < n_nodes; ++i)
      if (n_nodes == 2)
        {
          shape.N[i]     = 0.5 * (1. + corner[i][0] * xi[0]);
          shape.dN[i][0] = 0.5 * corner[i][0];
        }
      else
        {
          const double f1 = 1. + corner[i][0] * xi[0];
          const double f2 = 1. + corner[i][1] * xi[1];
          shape.N[i]      = 0.25 * f1 * f2;
          shape.dN[i][0]  = 0.25 * corner[i][0] * f2;
          shape.dN[i][1]  = 0.25 * corner[i][1] * f1;
          shape.d2N[i]    = 0.25 * corner[i][0] * corner[i][1];
        }
    return shape;
  }

  /// Point, base vectors a_1 and a_2, twist x,12 (all [mm]) and outward unit
  /// normal of a facet at some parameters, thesis (3.2) and (3.3).
  struct FacetFrame
  {
    FacetShape                          shape;
    dealii::Point<3>                    x;
    std::array<dealii::Tensor<1, 3>, 2> a;
    dealii::Tensor<1, 3>                twist;
    dealii::Tensor<1, 3>                normal;
  };

  /// Evaluates a facet at @p xi. A facet without area gets the normal 0.
  inline FacetFrame facet_frame(const FacetPositions   &facet,
                                const FacetCoordinates &xi)
  {
    FacetFrame frame;
    frame.shape = facet_shape(facet.n_nodes, xi);
    for (unsigned int i = 0; i < facet.n_nodes; ++i)
      {
        const dealii::Tensor<1, 3> x_i = facet.x[i];
        frame.x += frame.shape.N[i] * x_i;
        frame.a[0] += frame.shape.dN[i][0] * x_i;
        frame.a[1] += frame.shape.dN[i][1] * x_i;
        frame.twist += frame.shape.d2N[i] * x_i;
      }
    if (facet.n_nodes == 2)
      frame.a[1] = dealii::Point<3>(0., 0., 1.);
    const auto   direction = cross_product_3d(frame.a[0], frame.a[1]);
    const double length    = direction.norm();
    if (length > 0.)
      frame.normal = direction / length;
    return frame;
  }
} // namespace demold

#endif

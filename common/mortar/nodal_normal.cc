// SPDX-License-Identifier: LGPL-2.1-or-later
// Averaged normal of a slave node and its derivatives.
#include "mortar/nodal_normal.h"

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Below this length the sum of the unit normals has no direction.
    constexpr double shortest_sum = 1e-8;

    FacetCoordinates corner_coordinates(const unsigned int corner)
    {
      constexpr std::array<FacetCoordinates, 4> xi{
        {{{-1., -1.}}, {{1., -1.}}, {{1., 1.}}, {{-1., 1.}}}};
      return xi[corner];
    }

    FacetFrame frame_at_node(const FaceAround &around)
    {
      return facet_frame(around.face, corner_coordinates(around.corner));
    }

    /// The matrix of v -> u x v.
    Tensor<2, 3> cross_matrix(const Tensor<1, 3> &u)
    {
      Tensor<2, 3> m;
      m[0][1] = -u[2];
      m[0][2] = u[1];
      m[1][0] = u[2];
      m[1][2] = -u[0];
      m[2][0] = -u[1];
      m[2][1] = u[0];
      return m;
    }

    /// 1 - n n, without the out-of-plane direction in 2-D.
    Tensor<2, 3> tangential(const Tensor<1, 3> &n, const unsigned int n_nodes)
    {
      Tensor<2, 3> P;
      for (unsigned int i = 0; i < (n_nodes == 2 ? 2 : 3); ++i)
        P[i][i] = 1.;
      return P - outer_product(n, n);
    }

    /// dn_e/dx_I = (1 - n_e n_e)(N_I,2 [a_1 x] - N_I,1 [a_2 x])/|a_1 x a_2|.
    Tensor<2, 3> face_normal_derivative(const FacetFrame  &frame,
                                        const unsigned int n_nodes,
                                        const unsigned int I)
    {
      const double length = cross_product_3d(frame.a[0], frame.a[1]).norm();
      Tensor<2, 3> result = tangential(frame.normal, n_nodes) *
                            (frame.shape.dN[I][1] * cross_matrix(frame.a[0]) -
                             frame.shape.dN[I][0] * cross_matrix(frame.a[1])) /
                            length;
      if (n_nodes == 2)
        for (unsigned int i = 0; i < 3; ++i)
          result[i][2] = 0.;
      return result;
    }
  } // namespace

  NodalNormal nodal_normal(const std::vector<FaceAround> &around)
  {
    NodalNormal result;
    result.dn.resize(around.size());
    Tensor<1, 3> sum;
    for (const FaceAround &face : around)
      sum += frame_at_node(face).normal;
    const double length = sum.norm();
    if (length < shortest_sum)
      return result;
    result.n = sum / length;
    for (unsigned int e = 0; e < around.size(); ++e)
      {
        const FacetFrame   frame   = frame_at_node(around[e]);
        const unsigned int n_nodes = around[e].face.n_nodes;
        if (frame.normal.norm_square() == 0.)
          continue;
        const Tensor<2, 3> average = tangential(result.n, n_nodes) / length;
        for (unsigned int I = 0; I < n_nodes; ++I)
          result.dn[e][I] = average * face_normal_derivative(frame, n_nodes, I);
      }
    return result;
  }

  Tensor<1, 3> nodal_normal_value(const std::vector<FaceAround> &around)
  {
    Tensor<1, 3> sum;
    for (const FaceAround &face : around)
      sum += frame_at_node(face).normal;
    const double length = sum.norm();
    return length < shortest_sum ? Tensor<1, 3>() : sum / length;
  }
} // namespace demold

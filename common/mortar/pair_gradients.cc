// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of the mortar integrals of a pair by the positions of its nodes.
#include "mortar/pair_gradients.h"

#include "mortar/auxiliary_plane.h"
#include "mortar/pair_gradients_2d.h"
#include "mortar/segment_gradients.h"

namespace demold
{
  namespace
  {
    using Vector = dealii::Tensor<1, 3>;

    /// How the coordinates of the projected nodes change with the nodes:
    ///
    ///     dy_alpha = e_alpha.(dx - dx_10) - h (dn.e_alpha),
    ///     h = (x - x_10).n,   dn.e_alpha = sum_K tilt_alpha,K . dx_K.
    ///
    /// The integrals do not change if all points of the plane shift or turn
    /// about n. So dx_10 and the turning of e_alpha in the plane are left out.
    struct Projection3d
    {
      std::array<Vector, 2>                e;
      std::array<std::array<Vector, 4>, 2> tilt;     ///< [1/mm]
      std::array<double, 8>                height{}; ///< h [mm], slave, master
    };

    Projection3d projection(const AuxiliaryPlane<double> &plane,
                            const FaceNodes<double>      &slave,
                            const FaceNodes<double>      &master)
    {
      Projection3d result;
      result.e = plane.e;
      for (unsigned int i = 0; i < 2; ++i)
        {
          const Vector by_a1 = cross_product_3d(plane.a[1], plane.e[i]);
          const Vector by_a2 = cross_product_3d(plane.e[i], plane.a[0]);
          for (unsigned int K = 0; K < 4; ++K)
            result.tilt[i][K] =
              (centre_slope(4, K, 0) * by_a1 + centre_slope(4, K, 1) * by_a2) /
              plane.size;
        }
      for (unsigned int K = 0; K < 4; ++K)
        {
          result.height[K]     = (slave[K] - plane.centre) * plane.normal;
          result.height[4 + K] = (master[K] - plane.centre) * plane.normal;
        }
      return result;
    }

    /// Derivatives of integral @p q by the nodes from those in the plane.
    PairGradient in_space(const PlaneGradients &sums,
                          const unsigned int    q,
                          const Projection3d   &projection,
                          const DerivedBy       derived_by)
    {
      std::array<std::array<double, 2>, 8> by_node{};
      double                               tilting[2]{};
      for (unsigned int i = 0; i < 2; ++i)
        {
          for (unsigned int K = 0; K < 7; ++K)
            {
              by_node[K][i] = sums.nodes[K][i][q];
              by_node[7][i] -= by_node[K][i];
            }
          for (unsigned int K = 0; K < 8; ++K)
            tilting[i] += projection.height[K] * by_node[K][i];
        }

      PairGradient       result{};
      const unsigned int n = derived_by == DerivedBy::slave ? 4 : 8;
      for (unsigned int K = 0; K < n; ++K)
        for (unsigned int c = 0; c < 3; ++c)
          result[3 * K + c] = by_node[K][0] * projection.e[0][c] +
                              by_node[K][1] * projection.e[1][c];
      for (unsigned int K = 0; K < 4; ++K)
        for (unsigned int c = 0; c < 3; ++c)
          result[3 * K + c] -= tilting[0] * projection.tilt[0][K][c] +
                               tilting[1] * projection.tilt[1][K][c];
      return result;
    }

    void add(const double        factor,
             const PairGradient &gradient,
             PairGradient       &sum)
    {
      for (unsigned int k = 0; k < sum.size(); ++k)
        sum[k] += factor * gradient[k];
    }

    PairGradients collected(const PlaneGradients &sums,
                            const Projection3d   &projection,
                            const DerivedBy       derived_by)
    {
      PairGradients          result;
      PairIntegrals<double> &value = result.value;
      value.overlaps               = true;
      for (unsigned int A = 0; A < 4; ++A)
        {
          double       &last_M  = value.M[A][3];
          PairGradient &last_dM = result.dM[A][3];
          for (unsigned int B = 0; B < 4; ++B)
            {
              const unsigned int q = D_integral(A, B);
              value.D[A][B]        = sums.value[q];
              if (B < A)
                result.dD[A][B] = result.dD[B][A];
              else
                result.dD[A][B] = in_space(sums, q, projection, derived_by);
              last_M += value.D[A][B];
              add(1., result.dD[A][B], last_dM);
            }
          value.area += last_M;
          add(1., last_dM, result.darea);
          for (unsigned int C = 0; C < 3; ++C)
            {
              const unsigned int q = M_integral(A, C);
              value.M[A][C]        = sums.value[q];
              result.dM[A][C]      = in_space(sums, q, projection, derived_by);
              last_M -= value.M[A][C];
              add(-1., result.dM[A][C], last_dM);
            }
        }
      return result;
    }

    PairGradients gradients_3d(const FaceNodes<double> &slave,
                               const FaceNodes<double> &master,
                               const PairOptions       &options,
                               const DerivedBy          derived_by)
    {
      const AuxiliaryPlane<double> plane = auxiliary_plane(slave, 4);
      if (!(plane.size > 0.))
        return {};
      const PlaneNodes<double> y_slave  = projected(plane, slave, 4);
      const PlaneNodes<double> y_master = projected(plane, master, 4);
      const Segments3d         found    = find_segments(y_slave, y_master);
      if (found.n_segments == 0)
        return {};
      PlaneGradients sums;
      for (unsigned int i = 0; i < found.n_segments; ++i)
        add_segment_gradients(found.segments[i],
                              y_slave,
                              y_master,
                              triangle_rule(options.triangle_points),
                              sums);
      return collected(sums, projection(plane, slave, master), derived_by);
    }
  } // namespace

  PairGradients pair_gradients(const FacetPositions &slave,
                               const FacetPositions &master,
                               const PairOptions    &options,
                               const DerivedBy       derived_by)
  {
    if (slave.n_nodes == 2)
      return pair_gradients_2d(face_nodes(slave),
                               face_nodes(master),
                               options,
                               derived_by);
    return gradients_3d(face_nodes(slave),
                        face_nodes(master),
                        options,
                        derived_by);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// The side that is touched: a moving rigid mould or deformable rubber.
#include "contact/master.h"

#include "contact/closest_point.h"

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Orthonormal frame of a facet: along a_1, perpendicular in the facet,
    /// normal; as columns.
    Tensor<2, 3> orthonormal(const FacetFrame &frame)
    {
      const Tensor<1, 3> e1 = frame.a[0] / frame.a[0].norm();
      const Tensor<1, 3> e2 = cross_product_3d(frame.normal, e1);
      Tensor<2, 3>       Q;
      for (unsigned int i = 0; i < 3; ++i)
        {
          Q[i][0] = e1[i];
          Q[i][1] = e2[i];
          Q[i][2] = frame.normal[i];
        }
      return Q;
    }

    /// Change of orthonormal(frame) * @p offset per displacement of a node
    /// whose shape function has the slope @p dN along a_1.
    Tensor<2, 3> offset_change(const FacetFrame   &frame,
                               const Tensor<1, 3> &offset,
                               const double        dN,
                               const Tensor<2, 3> &dnormal)
    {
      const double       length = frame.a[0].norm();
      const Tensor<1, 3> e1     = frame.a[0] / length;
      Tensor<2, 3>       change;
      for (unsigned int j = 0; j < 3; ++j)
        {
          Tensor<1, 3> dn;
          for (unsigned int i = 0; i < 3; ++i)
            dn[i] = dnormal[i][j];
          Tensor<1, 3> de1 = -e1[j] * e1;
          de1[j] += 1.;
          de1 *= dN / length;
          const Tensor<1, 3> de2 =
            cross_product_3d(dn, e1) + cross_product_3d(frame.normal, de1);
          const Tensor<1, 3> dx =
            offset[0] * de1 + offset[1] * de2 + offset[2] * dn;
          for (unsigned int i = 0; i < 3; ++i)
            change[i][j] = dx[i];
        }
      return change;
    }
  } // namespace

  Master Master::rigid(std::vector<Facet>            facets,
                       std::vector<dealii::Point<3>> vertices,
                       RigidMotion                   motion)
  {
    Master master(ContactSurface(std::move(facets), vertices));
    master.vertices = std::move(vertices);
    master.motion   = std::move(motion);
    master.move_to(0.);
    return master;
  }

  Master Master::deformable(BoundarySurface boundary)
  {
    Master master(ContactSurface(boundary.facets, boundary.positions()));
    master.nodes = std::move(boundary.nodes);
    return master;
  }

  void Master::move_to(const double new_time)
  {
    time = new_time;
    now  = motion(time);
    std::vector<Point<3>> x;
    x.reserve(vertices.size());
    for (const Point<3> &X : vertices)
      x.push_back(now.place(X));
    surface.set_positions(x);
  }

  Anchor Master::set_anchor(const unsigned int      facet,
                            const FacetCoordinates &xi,
                            const Point<3>         &x_s) const
  {
    const FacetFrame frame = facet_frame(surface.facet_positions(facet), xi);
    Anchor           anchor;
    anchor.facet = facet;
    anchor.xi    = xi;
    if (is_rigid())
      {
        // The anchor of a rigid master is any point that moves with it.
        anchor.material        = now.material_point(x_s);
        anchor.material_normal = transpose(now.rotation) * frame.normal;
      }
    else
      anchor.offset = transpose(orthonormal(frame)) * (x_s - frame.x);
    return anchor;
  }

  Anchor Master::drag_anchor(const unsigned int facet, const Point<3> &x) const
  {
    const Projection       foot = project(x, surface.facet_positions(facet));
    const FacetCoordinates xi =
      foot.found ? foot.xi : FacetCoordinates{{0., 0.}};
    return set_anchor(facet, xi, is_rigid() || !foot.found ? x : foot.x);
  }

  Anchor Master::shifted(const Anchor &anchor, const Tensor<1, 3> &shift) const
  {
    Anchor result = anchor;
    if (is_rigid())
      result.material += transpose(now.rotation) * shift;
    else
      result.offset +=
        transpose(orthonormal(
          facet_frame(surface.facet_positions(anchor.facet), anchor.xi))) *
        shift;
    return result;
  }

  AnchorPlace Master::place(const Anchor &anchor) const
  {
    AnchorPlace result;
    if (is_rigid())
      {
        result.x      = now.place(anchor.material);
        result.normal = now.rotation * anchor.material_normal;
        return result;
      }
    const FacetFrame frame =
      facet_frame(surface.facet_positions(anchor.facet), anchor.xi);
    result.x       = frame.x + orthonormal(frame) * anchor.offset;
    result.normal  = frame.normal;
    result.n_nodes = surface.facet(anchor.facet).n_nodes;
    result.nodes   = surface.facet(anchor.facet).nodes;
    result.N       = frame.shape.N;

    // dn = -a^alpha (n . da_alpha) with the dual basis a^alpha
    const double a11 = frame.a[0] * frame.a[0], a12 = frame.a[0] * frame.a[1],
                 a22 = frame.a[1] * frame.a[1], det = a11 * a22 - a12 * a12;
    const Tensor<1, 3> dual[2] = {(a22 * frame.a[0] - a12 * frame.a[1]) / det,
                                  (a11 * frame.a[1] - a12 * frame.a[0]) / det};
    for (unsigned int i = 0; i < result.n_nodes; ++i)
      for (unsigned int alpha = 0; alpha < 2; ++alpha)
        result.dnormal[i] -=
          frame.shape.dN[i][alpha] * outer_product(dual[alpha], frame.normal);
    if (anchor.offset.norm_square() > 0.)
      for (unsigned int i = 0; i < result.n_nodes; ++i)
        result.doffset[i] = offset_change(frame,
                                          anchor.offset,
                                          frame.shape.dN[i][0],
                                          result.dnormal[i]);
    return result;
  }

  Tensor<1, 3> Master::displacement_since(const double    time_old,
                                          const Point<3> &x) const
  {
    if (!is_rigid())
      return Tensor<1, 3>();
    return x - motion(time_old).place(now.material_point(x));
  }

  Point<3> Master::carried(const double time_old, const Point<3> &x) const
  {
    return is_rigid() ? now.place(motion(time_old).material_point(x)) : x;
  }

  Tensor<1, 3> Master::velocity(const Point<3> &x, const double dt) const
  {
    if (!is_rigid() || dt <= 0.)
      return Tensor<1, 3>();
    return displacement_since(time - dt, x) / dt;
  }
} // namespace demold

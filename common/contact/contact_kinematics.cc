// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of the closest point; tangents of contact and friction force.
#include "contact/contact_kinematics.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Weight of node @p b of q in a force: 1 for the slave, -N_I beyond.
    double weight(const ContactKinematics &kin, const unsigned int b)
    {
      return b == 0 ? 1. : -kin.N[b - 1];
    }

    /// Derivative of that weight by entry @p j of q.
    double weight_derivative(const ContactKinematics &kin,
                             const unsigned int       b,
                             const unsigned int       j)
    {
      if (b == 0)
        return 0.;
      return -kin.dN_dxi[b - 1][0] * kin.dxi[0][j] -
             kin.dN_dxi[b - 1][1] * kin.dxi[1][j];
    }

    /// dx_s - sum N_I dx_I for a unit change of entry @p j of q.
    Tensor<1, 3> relative_change(const ContactKinematics &kin,
                                 const unsigned int       j)
    {
      Tensor<1, 3> dd;
      if (!(kin.in_plane && j % 3 == 2))
        dd[j % 3] = weight(kin, j / 3);
      return dd;
    }

    void store(std::array<std::array<double, 15>, 3> &matrix,
               const unsigned int                     j,
               const Tensor<1, 3>                    &column)
    {
      for (unsigned int i = 0; i < 3; ++i)
        matrix[i][j] = column[i];
    }

    Tensor<1, 3> column(const std::array<std::array<double, 15>, 3> &matrix,
                        const unsigned int                           j)
    {
      Tensor<1, 3> result;
      for (unsigned int i = 0; i < 3; ++i)
        result[i] = matrix[i][j];
      return result;
    }

    void face_derivatives(const FacetFrame &frame, ContactKinematics &kin)
    {
      const auto        &a = frame.a;
      const Tensor<1, 3> d = kin.x_s - kin.x_m;
      const double m11 = a[0] * a[0], m12 = a[0] * a[1], m22 = a[1] * a[1];
      const double metric = m11 * m22 - m12 * m12;
      const std::array<Tensor<1, 3>, 2> dual{
        {(m22 * a[0] - m12 * a[1]) / metric,
         (m11 * a[1] - m12 * a[0]) / metric}};
      const double H12  = m12 - d * frame.twist;
      const double det  = m11 * m22 - H12 * H12;
      const double bend = kin.normal * frame.twist;

      for (unsigned int j = 0; j < kin.n_dofs(); ++j)
        {
          const auto dd = relative_change(kin, j);
          kin.dgap[j]   = kin.normal * dd;
          if (kin.in_plane && j % 3 == 2)
            continue;
          // sum N_I,a dx_I has one entry, in direction c = j % 3.
          const unsigned int    c = j % 3;
          std::array<double, 2> da{};
          if (j >= 3)
            da = kin.dN_dxi[j / 3 - 1];
          const double F1 = a[0] * dd + d[c] * da[0];
          const double F2 = kin.in_plane ? 0. : a[1] * dd + d[c] * da[1];
          kin.dxi[0][j]   = (m22 * F1 - H12 * F2) / det;
          kin.dxi[1][j]   = (m11 * F2 - H12 * F1) / det;

          const double n_c = kin.normal[c];
          const auto   dn  = -(n_c * da[0] + bend * kin.dxi[1][j]) * dual[0] -
                          (n_c * da[1] + bend * kin.dxi[0][j]) * dual[1];
          store(kin.dnormal, j, dn);
          store(kin.gap_dnormal, j, kin.gap * dn);
        }
    }

    /// @p half: half the edge vector, 0 at a vertex. @p size [mm] decides
    /// which distance is none.
    void border_derivatives(const Tensor<1, 3> &half,
                            const double        size,
                            const Tensor<1, 3> &mean_normal,
                            ContactKinematics  &kin)
    {
      const Tensor<1, 3> d        = kin.x_s - kin.x_m;
      const double       distance = d.norm();
      const bool         is_hit   = distance <= 1e-10 * size;
      const double       side     = d * mean_normal < 0. ? -1. : 1.;
      kin.gap                     = side * distance;
      kin.normal                  = is_hit ? mean_normal : side / distance * d;

      for (unsigned int j = 0; j < kin.n_dofs(); ++j)
        {
          auto dd = relative_change(kin, j);
          if (half.norm_square() > 0.)
            {
              const double F =
                half * dd + (j >= 3 ? d[j % 3] * kin.dN_dxi[j / 3 - 1][0] : 0.);
              kin.dxi[0][j] = F / half.norm_square();
              // The part of dx_m along the edge.
              dd -= kin.dxi[0][j] * half;
            }
          kin.dgap[j]       = kin.normal * dd;
          const auto across = dd - kin.normal * kin.dgap[j];
          store(kin.gap_dnormal, j, across);
          if (!is_hit)
            store(kin.dnormal, j, across / kin.gap);
        }
    }
  } // namespace

  ContactKinematics contact_kinematics(const ContactPoint   &point,
                                       const Point<3>       &x_s,
                                       const ContactSurface &surface)
  {
    const FacetPositions facet = surface.facet_positions(point.facet);

    ContactKinematics kin;
    kin.n_nodes  = point.n_nodes;
    kin.nodes    = point.nodes;
    kin.x_s      = x_s;
    kin.in_plane = surface.n_dimensions() == 2;
    if (point.kind == ContactCase::face)
      {
        const FacetFrame frame = facet_frame(facet, point.xi);
        kin.N                  = frame.shape.N;
        kin.dN_dxi             = frame.shape.dN;
        kin.normal             = frame.normal;
        kin.x_m                = frame.x;
        kin.gap                = frame.normal * (x_s - frame.x);
        face_derivatives(frame, kin);
        return kin;
      }

    const auto  &x = surface.positions();
    Tensor<1, 3> half;
    if (point.kind == ContactCase::edge)
      {
        const auto shape = facet_shape(2, point.xi);
        kin.N            = shape.N;
        kin.dN_dxi       = shape.dN;
        half             = 0.5 * (x[point.nodes[1]] - x[point.nodes[0]]);
      }
    else
      kin.N[0] = 1.;
    for (unsigned int i = 0; i < kin.n_nodes; ++i)
      kin.x_m += kin.N[i] * Tensor<1, 3>(x[kin.nodes[i]]);
    border_derivatives(half,
                       (facet.x[1] - facet.x[0]).norm(),
                       point.mean_normal,
                       kin);
    return kin;
  }

  void normal_contact_force(const ContactKinematics                &kin,
                            const double                            stiffness,
                            std::array<double, 15>                 &R,
                            std::array<std::array<double, 15>, 15> &K)
  {
    for (unsigned int b = 0; b <= kin.n_nodes; ++b)
      for (unsigned int c = 0; c < 3; ++c)
        {
          const double t = stiffness * kin.gap * kin.normal[c];
          R[3 * b + c]   = weight(kin, b) * t;
          for (unsigned int j = 0; j < kin.n_dofs(); ++j)
            K[3 * b + c][j] =
              weight(kin, b) * stiffness *
                (kin.normal[c] * kin.dgap[j] + kin.gap_dnormal[c][j]) +
              weight_derivative(kin, b, j) * t;
        }
  }

  namespace
  {
    /// Derivative of (1 - n n)(x_s - x_anchor) by entry @p j of q.
    Tensor<1, 3> tangential_gap_change(const ContactKinematics &kin,
                                       const FrictionAnchor    &anchor,
                                       const unsigned int       j)
    {
      const Tensor<1, 3> &n      = kin.normal;
      const Tensor<1, 3>  r      = kin.x_s - anchor.x;
      const unsigned int  n_kin  = kin.n_dofs();
      const bool          absent = kin.in_plane && j % 3 == 2;
      Tensor<1, 3>        dr;
      if (j < 3 && !absent)
        dr[j] = 1.;
      else if (j >= n_kin && !absent)
        dr[j % 3] = -anchor.N[(j - n_kin) / 3];
      Tensor<1, 3> dg = dr - n * (n * dr);
      if (j < n_kin)
        {
          const auto dn = column(kin.dnormal, j);
          dg -= dn * (n * r) + n * (dn * r);
        }
      return dg;
    }
  } // namespace

  double loss_of_opening(const Tensor<1, 3> &traction, const Tensor<1, 3> &gap)
  {
    return std::max(0., .5 * traction * gap);
  }

  FrictionForce friction_force(const ContactKinematics &kin,
                               const FrictionAnchor    &anchor,
                               const FrictionPenalties &penalties)
  {
    FrictionForce force;
    force.n_dofs = kin.n_dofs() + 3 * anchor.n_nodes;

    const Tensor<1, 3> &n = kin.normal;
    Tensor<1, 3>        g = kin.x_s - anchor.x;
    g -= n * (n * g);
    const double c_T = penalties.tangential;
    force.trial      = c_T * g.norm();
    force.limit =
      penalties.coefficient * penalties.normal * std::max(0., -kin.gap);
    if (force.limit <= 0.)
      {
        force.slip        = g;
        force.dissipation = loss_of_opening(anchor.traction, g);
        return force;
      }

    const bool         sticks = force.trial <= force.limit;
    const double       factor = sticks ? 1. : force.limit / force.trial;
    const Tensor<1, 3> m      = sticks ? Tensor<1, 3>() : c_T / force.trial * g;
    force.state       = sticks ? FrictionState::stick : FrictionState::slip;
    force.traction    = factor * c_T * g;
    force.slip        = (force.trial - force.limit) / c_T * m;
    force.dissipation = .5 * (anchor.limit + force.limit) * force.slip.norm();
    force.stored      = 0.5 * force.traction.norm_square() / c_T;

    for (unsigned int j = 0; j < force.n_dofs; ++j)
      {
        const bool is_kin = j < kin.n_dofs();
        const auto dt_tr  = c_T * tangential_gap_change(kin, anchor, j);
        const auto dL =
          is_kin ? -penalties.coefficient * penalties.normal * kin.dgap[j] : 0.;
        const auto dt = factor * (dt_tr - m * (m * dt_tr)) + m * dL;
        for (unsigned int b = 0; b <= kin.n_nodes; ++b)
          for (unsigned int c = 0; c < 3; ++c)
            force.K[3 * b + c][j] =
              weight(kin, b) * dt[c] +
              (is_kin ? weight_derivative(kin, b, j) * force.traction[c] : 0.);
      }
    for (unsigned int b = 0; b <= kin.n_nodes; ++b)
      for (unsigned int c = 0; c < 3; ++c)
        force.R[3 * b + c] = weight(kin, b) * force.traction[c];
    return force;
  }

  Point<3> new_anchor(const ContactKinematics &kin,
                      const FrictionAnchor    &anchor,
                      const FrictionForce     &force,
                      const FrictionPenalties &penalties)
  {
    if (force.state == FrictionState::stick)
      return anchor.x;
    return kin.x_s - kin.gap * kin.normal -
           force.traction / penalties.tangential;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Gap, normal and their derivatives; contact and friction force of a node.
#ifndef demold_contact_contact_kinematics_h
#define demold_contact_contact_kinematics_h

#include "contact/closest_point.h"
#include "contact/contact_surface.h"

#include <array>

namespace demold
{
  /// Geometry of one slave node against the master, with derivatives with
  /// respect to q = (x_s, x_1 ... x_n_nodes), three entries per node. In 2-D
  /// all entries along z are zero. The weights of the nodes in a contact force
  /// are (1, -N_1 ... -N_n_nodes).
  struct ContactKinematics
  {
    unsigned int                         n_nodes; ///< of the master: 1, 2, 4
    std::array<unsigned int, 4>          nodes{}; ///< their numbers
    std::array<double, 4>                N{};     ///< at the closest point
    std::array<std::array<double, 2>, 4> dN_dxi{};
    double                               gap; ///< [mm] > 0 open, thesis (3.7)
    dealii::Tensor<1, 3>                 normal; ///< from master towards slave
    dealii::Point<3>                     x_s;    ///< [mm] slave node
    dealii::Point<3>                     x_m;    ///< [mm] closest point
    bool                                 in_plane; ///< 2-D: z is left out

    std::array<double, 15>                dgap{};        ///< [-]
    std::array<std::array<double, 15>, 2> dxi{};         ///< [1/mm]
    std::array<std::array<double, 15>, 3> dnormal{};     ///< [1/mm]
    std::array<std::array<double, 15>, 3> gap_dnormal{}; ///< [-] gap * dnormal

    /// Length of q.
    unsigned int n_dofs() const
    {
      return 3 * (1 + n_nodes);
    }
  };

  /// Kinematics of the closest point @p point of the slave node at @p x_s, at
  /// the positions @p surface had when the point was found:
  ///
  ///     face:  H_ab dxi^b = a_a.dd + d.sum N_I,a dx_I,
  ///            H_ab = a_a.a_b - d.x_,ab,   dd = dx_s - sum N_I dx_I,
  ///            dgap = n.dd,   dn = -a^a (n.(sum N_I,a dx_I + x_,ab dxi^b))
  ///     edge, vertex:  d = x_s - x_m = gap n,   gap dn = (1 - n n) dd
  ///
  /// At an edge or vertex hit exactly (d = 0) the mean normal stands in for
  /// n, with dnormal = 0; gap_dnormal is regular there.
  ContactKinematics contact_kinematics(const ContactPoint     &point,
                                       const dealii::Point<3> &x_s,
                                       const ContactSurface   &surface);

  /// Residual and exact, symmetric tangent of the energy ½ stiffness gap²:
  /// R = stiffness gap n with the weights of the nodes (thesis 3.10). Only the
  /// first n_dofs() entries are written. A penalty in MPa/mm as @p stiffness
  /// gives MPa and MPa/mm, multiplied with the nodal area N and N/mm. Holds
  /// for either sign of the gap: the caller decides what is in contact.
  void normal_contact_force(const ContactKinematics                &kin,
                            const double                            stiffness,
                            std::array<double, 15>                 &R,
                            std::array<std::array<double, 15>, 15> &K);

  /// The stick point on the master: a material point of the master, given by
  /// nodes and weights. A rigid master needs its position alone; n_nodes = 0.
  struct FrictionAnchor
  {
    unsigned int                n_nodes = 0;
    std::array<unsigned int, 4> nodes{};
    std::array<double, 4>       N{};
    dealii::Point<3>            x;          ///< [mm] current position
    dealii::Tensor<1, 3>        traction;   ///< t at the step's start [MPa]
    double                      limit = 0.; ///< L then [MPa]
  };

  /// Penalties as in normal_contact_force(): per area or times area.
  struct FrictionPenalties
  {
    double normal;      ///< c_N [MPa/mm]
    double tangential;  ///< c_T [MPa/mm]
    double coefficient; ///< mu times omega (theory C.3) [-]
  };

  enum class FrictionState
  {
    open, ///< no pressure or no friction
    stick,
    slip
  };

  /// Friction at one slave node. q = (x_s, nodes of the contact kinematics,
  /// nodes of the anchor): a node may occur in both lists.
  struct FrictionForce
  {
    unsigned int                           n_dofs; ///< length of q, <= 27
    FrictionState                          state = FrictionState::open;
    std::array<double, 27>                 R{};
    std::array<std::array<double, 27>, 27> K{}; ///< unsymmetric in slip

    dealii::Tensor<1, 3> traction;         ///< t [MPa]; R holds +t at the slave
    double               trial = 0.;       ///< |t_tr| [MPa]
    double               limit = 0.;       ///< L [MPa]
    dealii::Tensor<1, 3> slip;             ///< [mm] increment of this step
    double               dissipation = 0.; ///< of this step [mJ/mm^2]
    double               stored      = 0.; ///< c_T/2 |elastic gap|^2 [mJ/mm^2]
  };

  /// Dissipation [mJ/mm^2] of a point that held @p traction [MPa] and opens
  /// when its stick point is @p gap [mm] behind: the trapezoidal rule.
  double loss_of_opening(const dealii::Tensor<1, 3> &traction,
                         const dealii::Tensor<1, 3> &gap);

  /// Moving friction cone (theory C.3, thesis 3.16 with erratum E8):
  /// t_tr = c_T (1 - n n)(x_s - x_anchor), limit L = mu omega <-c_N gap>;
  /// stick t = t_tr, slip t = L t_tr/|t_tr|. The force acts with the weights
  /// of the closest point. The tangent is exact: moving normal, moving
  /// weights, pressure dependence of L; omega counts as constant.
  ///
  /// The dissipation is ½ (L_n + L_n+1) |slip|: exact where the limit changes
  /// linearly over the slip, also when the point has stuck at first. A point
  /// that opens loses loss_of_opening().
  FrictionForce friction_force(const ContactKinematics &kin,
                               const FrictionAnchor    &anchor,
                               const FrictionPenalties &penalties);

  /// Where the stick point is after the step [mm]: unmoved in stick, dragged
  /// to x_s - gap n - t/c_T in slip, under the slave node when open. On a
  /// curved master the caller projects it back onto the surface.
  dealii::Point<3> new_anchor(const ContactKinematics &kin,
                              const FrictionAnchor    &anchor,
                              const FrictionForce     &force,
                              const FrictionPenalties &penalties);
} // namespace demold

#endif

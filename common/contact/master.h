// SPDX-License-Identifier: LGPL-2.1-or-later
// The side that is touched: a moving rigid mould or deformable rubber.
#ifndef demold_contact_master_h
#define demold_contact_master_h

#include "base/rigid_motion.h"
#include "contact/boundary_surface.h"
#include "contact/contact_surface.h"

#include <iosfwd>
#include <optional>
#include <vector>

namespace demold
{
  /// A material point of the master that somebody remembers: the foot of a
  /// bond (x_a, theory C2) or of a sticking contact.
  struct Anchor
  {
    unsigned int         facet = 0;
    FacetCoordinates     xi{};
    dealii::Point<3>     material;        ///< rigid master: reference point
    dealii::Tensor<1, 3> material_normal; ///< rigid master: normal there
    /// Slave point minus foot when the anchor was set, in the frame of the
    /// facet (a_1 direction, a_2 perpendicular, normal): a bond over a small
    /// initial gap is free of stress.
    dealii::Tensor<1, 3> offset;
  };

  /// Where an anchor is now, and how that depends on the master nodes.
  struct AnchorPlace
  {
    dealii::Point<3>            x;
    dealii::Tensor<1, 3>        normal;
    unsigned int                n_nodes = 0; ///< 0: rigid
    std::array<unsigned int, 4> nodes{};
    std::array<double, 4>       N{};
    /// dn/dx_I at fixed parameters, one 3 x 3 matrix per node.
    std::array<dealii::Tensor<2, 3>, 4> dnormal{};
    /// Part of dx/dx_I beyond N_I 1: the offset turns with the facet.
    std::array<dealii::Tensor<2, 3>, 4> doffset{};
  };

  class Master
  {
  public:
    /// A rigid master in its closed position, moved by @p motion.
    static Master rigid(std::vector<Facet>            facets,
                        std::vector<dealii::Point<3>> vertices,
                        RigidMotion                   motion);

    /// A deformable one.
    static Master deformable(BoundarySurface surface);

    bool is_rigid() const
    {
      return static_cast<bool>(motion);
    }

    /// Moves a rigid master to @p time.
    void move_to(const double time);

    /// Current surface.
    ContactSurface surface;

    /// Nodes of a deformable master, empty for a rigid one.
    std::vector<BoundarySurface::Node> nodes;

    /// Sets an anchor on a facet at its present place; @p x_s is the slave
    /// point whose offset from the foot is remembered.
    Anchor set_anchor(const unsigned int      facet,
                      const FacetCoordinates &xi,
                      const dealii::Point<3> &x_s) const;

    /// Anchor at the foot of @p x on a facet, or on its continuation; on a
    /// rigid master at @p x itself.
    Anchor drag_anchor(const unsigned int      facet,
                       const dealii::Point<3> &x) const;

    /// @p anchor moved by @p shift [mm] (plastic unloading, theory C.2).
    Anchor shifted(const Anchor               &anchor,
                   const dealii::Tensor<1, 3> &shift) const;

    AnchorPlace place(const Anchor &anchor) const;

    /// Displacement [mm] of the rigid material point now at @p x since
    /// @p time_old; zero for a deformable master.
    dealii::Tensor<1, 3> displacement_since(const double            time_old,
                                            const dealii::Point<3> &x) const;

    /// Where @p x would be if it had moved with the rigid master since
    /// @p time_old [s]; @p x itself for a deformable one.
    dealii::Point<3> carried(const double            time_old,
                             const dealii::Point<3> &x) const;

    /// Velocity [mm/s] of the rigid material point now at @p x, from the
    /// displacement over the last @p dt.
    dealii::Tensor<1, 3> velocity(const dealii::Point<3> &x,
                                  const double            dt) const;

  private:
    Master(ContactSurface surface)
      : surface(std::move(surface))
    {}

    std::vector<dealii::Point<3>> vertices; ///< rigid: reference
    RigidMotion                   motion;
    RigidPlacement                now;
    double                        time = 0.;
  };
} // namespace demold

#endif

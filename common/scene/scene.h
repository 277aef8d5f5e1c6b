// SPDX-License-Identifier: LGPL-2.1-or-later
// Geometry and motion of a scene: what a step hands to the simulation.
#ifndef demold_scene_scene_h
#define demold_scene_scene_h

#include "base/rigid_motion.h"
#include "geometry/rigid_surface.h"
#include "material/rubber_law.h"

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace dealii
{
  template <int dim, int spacedim>
  class Triangulation;
}

namespace demold
{
  /// Holds or drives one displacement component on a part of the boundary.
  struct SupportRule
  {
    /// Boundary id, or nothing: every node of the body.
    std::optional<dealii::types::boundary_id> boundary;
    unsigned int                              component;

    /// Of a reference position X; none: everywhere on the boundary.
    std::function<bool(const dealii::Point<3> &X)> where;

    /// [mm] at reference position X and time t [s].
    std::function<double(double t, const dealii::Point<3> &X)> value =
      [](double, const dealii::Point<3> &) { return 0.; };
  };

  /// A dead load per reference area.
  struct TractionRule
  {
    dealii::types::boundary_id                  boundary;
    std::function<dealii::Tensor<1, 3>(double)> traction; ///< [MPa] of t [s]
  };

  /// A scene without its rubber and its interface.
  template <int dim>
  struct Scene
  {
    std::function<void(dealii::Triangulation<dim, dim> &)> make_mesh;
    std::vector<SupportRule>                               supports;
    std::vector<TractionRule>                              tractions;

    /// Laws by material id of what is not of the rubber of section Material.
    std::map<dealii::types::material_id, RubberLaw> laws;

    /// Boundaries that may touch, and what they touch: a rigid mould or the
    /// boundaries of another body.
    std::set<dealii::types::boundary_id> slave;
    std::optional<RigidSurface>          mould;
    RigidMotion                          motion;
    std::set<dealii::types::boundary_id> master;

    /// What the mould and what the bladder touch in the press that cures the
    /// rubber, for Material/cure = vulcanised. No heat passes elsewhere.
    std::set<dealii::types::boundary_id> mould_side, bladder_side;

    /// Whole block over modelled part; results are of the whole.
    double symmetry_factor = 1.;

    /// Where the force is measured: on the mould, at a driven boundary, or as
    /// the one whose work over the opening is that of all supports.
    enum class ForceOn
    {
      mould,
      boundary,
      supports
    };
    ForceOn                    force_on       = ForceOn::mould;
    dealii::types::boundary_id force_boundary = 0;

    /// Travel of mould or grip [mm] and its direction at time t [s].
    std::function<double(double)>               opening;
    std::function<dealii::Tensor<1, 3>(double)> direction;

    double end_time = 1.; ///< [s]

    /// The run ends this far [mm] behind the last bond or touch; negative:
    /// it goes on to the end time.
    double after_release = -1.;

    double height = 1.; ///< [mm] of rubber behind the interface, for Omega
  };
} // namespace demold

#endif

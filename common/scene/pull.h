// SPDX-License-Identifier: LGPL-2.1-or-later
// How the mould moves: velocity, direction and tilt over time.
#ifndef demold_scene_pull_h
#define demold_scene_pull_h

#include "base/rigid_motion.h"

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Section Pull. The mould travels with a velocity along a direction and may
  /// turn about a centre; the backing of the block stands still.
  struct Pull
  {
    std::string velocity    = "50";   ///< v [mm/s]
    double      ramp        = .005;   ///< [s], for a velocity that is a number
    std::string direction   = "down"; ///< or formulas "dx, dy, dz"
    std::string inclination = "0";    ///< [degree] from the direction to +x
    std::string tilt        = "0";    ///< [degree]
    std::string tilt_centre = "0, 0, 0"; ///< [mm]
    double      opening     = 10.;       ///< [mm] of travel at the end
    double      after       = 1.;        ///< [mm] beyond the last release

    void add_parameters(dealii::ParameterHandler &prm);
    void check(int dim) const;

    /// Placement of the mould; @p dim 2: the vertical is y, 3: z.
    RigidMotion motion(int dim) const;

    /// Path travelled [mm] at time @p t [s].
    double travel(double t) const;

    /// Time [s] at which `opening` is reached.
    double duration() const;

    /// Unit vector of the opening at time @p t [s]: force is positive along
    /// it.
    dealii::Tensor<1, 3> opening_direction(int dim, double t) const;
  };
} // namespace demold

#endif

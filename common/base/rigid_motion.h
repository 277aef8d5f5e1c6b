// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a rigid body is: rotation about a centre, then translation.
#ifndef demold_base_rigid_motion_h
#define demold_base_rigid_motion_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <functional>

namespace demold
{
  /// Placement of a rigid body: x = centre + R (X - centre) + translation.
  struct RigidPlacement
  {
    dealii::Tensor<2, 3> rotation = unit(); ///< R, proper orthogonal
    dealii::Point<3>     centre;            ///< [mm]
    dealii::Tensor<1, 3> translation;       ///< [mm]

    dealii::Point<3> place(const dealii::Point<3> &X) const
    {
      return centre + rotation * (X - centre) + translation;
    }

    /// The material point now at @p x.
    dealii::Point<3> material_point(const dealii::Point<3> &x) const
    {
      return centre + transpose(rotation) * (x - centre - translation);
    }

  private:
    static dealii::Tensor<2, 3> unit()
    {
      dealii::Tensor<2, 3> one;
      one[0][0] = one[1][1] = one[2][2] = 1.;
      return one;
    }
  };

  /// Placement as a function of time [s].
  using RigidMotion = std::function<RigidPlacement(double)>;
} // namespace demold

#endif

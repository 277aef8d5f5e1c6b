// SPDX-License-Identifier: LGPL-2.1-or-later
// The homogeneous tests a laboratory can do, as a family of F.
#include "rig/rig_mode.h"

#include <cmath>

namespace demold
{
  RigMode rig_mode_by_name(const std::string &name)
  {
    for (const RigMode mode : {RigMode::equibiaxial,
                               RigMode::pure_shear,
                               RigMode::simple_shear,
                               RigMode::confined})
      if (name == name_of(mode))
        return mode;
    return RigMode::uniaxial;
  }



  std::string name_of(const RigMode mode)
  {
    switch (mode)
      {
        case RigMode::equibiaxial:
          return "equibiaxial";
        case RigMode::pure_shear:
          return "pure shear";
        case RigMode::simple_shear:
          return "simple shear";
        case RigMode::confined:
          return "confined";
        default:
          return "uniaxial";
      }
  }



  RigKinematics::RigKinematics(const RigMode mode)
    : n_driven(mode == RigMode::equibiaxial ? 2 : 1)
    , n_lateral(mode == RigMode::uniaxial ? 2 :
                mode == RigMode::equibiaxial || mode == RigMode::pure_shear ?
                                            1 :
                                            0)
    , is_shear(mode == RigMode::simple_shear)
  {
    if (is_shear)
      {
        driven[0][1] = 1.;
        for (unsigned int i = 0; i < 3; ++i)
          fixed[i][i] = 1.;
        return;
      }
    for (unsigned int i = 0; i < 3; ++i)
      (i < n_driven ? driven : i >= 3 - n_lateral ? lateral : fixed)[i][i] = 1.;
  }



  double RigKinematics::lateral_of_volume(const double x, const double J) const
  {
    return n_lateral == 0 ? 1. :
                            std::pow(J / std::pow(x, n_driven), 1. / n_lateral);
  }
} // namespace demold

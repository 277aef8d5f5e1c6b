// SPDX-License-Identifier: LGPL-2.1-or-later
// How shear counts beside opening: the two factors of mixed mode.
#include "adhesion/mode_mixing.h"

#include "base/parameter_error.h"

namespace demold
{
  ModeMixing mode_mixing(const std::string &name)
  {
    if (name == "isotropic")
      return ModeMixing::isotropic;
    if (name == "slip limit")
      return ModeMixing::slip_limit;
    if (name == "energy")
      return ModeMixing::energy;
    if (name == "proportional")
      return ModeMixing::proportional;
    throw ExcParameter("Adhesion/mixing",
                       "must be isotropic, slip limit, energy or "
                       "proportional; got '" +
                         name + "'.");
  }



  ModeFactors mode_factors(const ModeMixing mixing, const double coupling)
  {
    switch (mixing)
      {
        case ModeMixing::slip_limit:
          return {coupling, 1.};
        case ModeMixing::energy:
          return {coupling * coupling, coupling};
        case ModeMixing::proportional:
          return {1., 1. / coupling};
        case ModeMixing::isotropic:
          break;
      }
    return {1., 1.};
  }
} // namespace demold

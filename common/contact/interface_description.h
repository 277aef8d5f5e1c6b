// SPDX-License-Identifier: LGPL-2.1-or-later
// What acts between two surfaces: penalties, friction, bond.
#ifndef demold_contact_interface_description_h
#define demold_contact_interface_description_h

#include "adhesion/adhesion_law.h"
#include "base/plane_model.h"

#include <deal.II/base/point.h>

#include <functional>
#include <optional>

namespace demold
{
  /// What acts between the surfaces.
  struct InterfaceDescription
  {
    double                     penalty          = 200.; ///< c_N [MPa/mm]
    double                     search_distance  = 1.;   ///< [mm]
    double                     skin             = .5;   ///< [mm]
    double                     friction         = 0.;   ///< mu [-], 0: none
    double                     friction_penalty = 50.;  ///< c_T [MPa/mm]
    std::optional<AdhesionLaw> adhesion;

    /// Is this reference position bonded at the start?
    std::function<bool(const dealii::Point<3> &)> bonded =
      [](const dealii::Point<3> &) { return true; };
    PlaneModel plane;
  };
} // namespace demold

#endif

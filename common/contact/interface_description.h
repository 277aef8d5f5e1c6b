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
  /// Gap [mm] that counts as touching: surfaces that meet at the start hold
  /// each other in the first iteration.
  constexpr double touching_gap = 1e-10;

  /// What acts between the surfaces.
  struct InterfaceDescription
  {
    double penalty          = 200.; ///< c_N [MPa/mm]
    double search_distance  = 1.;   ///< [mm]
    double skin             = .5;   ///< [mm]
    double friction         = 0.;   ///< mu [-], 0: none
    double friction_penalty = 50.;  ///< c_T [MPa/mm]

    // Of the mortar form.
    double       augmentation     = 0.; ///< c_N [MPa/mm]; 0: chosen, theory C8
    double       stiffness        = 1.; ///< E [MPa] of the rubber, to choose it
    bool         dual_multipliers = false;
    bool         condensed        = false; ///< dual ones on a rigid mould
    unsigned int quadrature_order = 5;     ///< degree integrated exactly

    std::optional<AdhesionLaw> adhesion;

    /// Do bonds form where surfaces are pressed together for the first time,
    /// rather than where they meet at the start? Node to segment only.
    bool bonds_on_touch = false;

    /// May this reference position bond?
    std::function<bool(const dealii::Point<3> &)> bonded =
      [](const dealii::Point<3> &) { return true; };
    PlaneModel plane;
  };
} // namespace demold

#endif

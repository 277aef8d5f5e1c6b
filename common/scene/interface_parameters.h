// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections Contact, Friction and Adhesion of a parameter file.
#ifndef demold_scene_interface_parameters_h
#define demold_scene_interface_parameters_h

#include "adhesion/adhesion_parameters.h"
#include "contact/node_to_segment.h"

#include <string>

namespace demold
{
  /// What acts between rubber and mould, as a user writes it down.
  struct InterfaceParameters
  {
    std::string        formulation      = "node to segment";
    double             penalty          = 200.; ///< c_N [MPa/mm]
    double             search_distance  = 1.;   ///< [mm]
    double             friction         = 0.;   ///< mu [-]
    double             friction_penalty = 50.;  ///< c_T [MPa/mm]
    std::string        bonded           = "1";
    AdhesionParameters adhesion;

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;

    bool active() const
    {
      return formulation != "none";
    }

    /// The description the contact term is made from.
    InterfaceDescription description(const PlaneModel &plane) const;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections Contact, Friction and Adhesion of a parameter file.
#ifndef demold_scene_interface_parameters_h
#define demold_scene_interface_parameters_h

#include "adhesion/adhesion_parameters.h"
#include "contact/interface_description.h"

#include <string>

namespace demold
{
  /// What acts between rubber and mould, as a user writes it down.
  struct InterfaceParameters
  {
    std::string        formulation      = "node to segment";
    double             penalty          = 200.; ///< c_N [MPa/mm]
    double             augmentation     = 0.;   ///< c_N of mortar [MPa/mm]
    std::string        multipliers      = "standard"; ///< | dual
    bool               condensed        = false;
    unsigned int       quadrature_order = 5;
    double             search_distance  = 1.;  ///< [mm]
    double             friction         = 0.;  ///< mu [-]
    double             friction_penalty = 50.; ///< c_T [MPa/mm]
    std::string        bonded           = "1";
    std::string        bonds_form       = "at the start"; ///< | on touch
    AdhesionParameters adhesion;

    void add_parameters(dealii::ParameterHandler &prm);

    /// @p element of the rubber, which not every formulation can use.
    void check(const std::string &element) const;

    bool active() const
    {
      return formulation != "none";
    }

    bool is_mortar() const
    {
      return formulation == "mortar";
    }

    /// The description the contact term is made from; @p stiffness [MPa] is
    /// Young's modulus of the rubber.
    InterfaceDescription description(const PlaneModel &plane,
                                     const double      stiffness) const;

  private:
    void check_mortar(const std::string &element) const;
  };
} // namespace demold

#endif

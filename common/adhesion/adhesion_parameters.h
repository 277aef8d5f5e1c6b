// SPDX-License-Identifier: LGPL-2.1-or-later
// The section "Adhesion" of a parameter file.
#ifndef demold_adhesion_adhesion_parameters_h
#define demold_adhesion_adhesion_parameters_h

#include "adhesion/adhesion_law.h"

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Adhesion as a user writes it down; law() makes the law of it.
  struct AdhesionParameters
  {
    std::string law_name              = "none";
    double      strength              = 0.1;      ///< alpha [MPa]
    double      rupture_gap           = 0.2;      ///< delta or delta_e [mm]
    double      penalty               = 20.;      ///< gamma [MPa/mm]
    double      tangential_coupling   = 0.5;      ///< beta_T [-]
    std::string mixing                = "energy"; ///< theory C.2
    std::string unloading             = "damage"; ///< or "plastic"
    std::string friction_weight       = "full";   ///< omega, theory C.3
    double      readhesion_pressure   = 0.1;      ///< p_re [MPa]
    double      readhesion_time       = 1.;       ///< t_re [s]
    double      readhesion_efficiency = 0.;       ///< eta_re [-], 0 = off
    double      viscous_time          = 0.;       ///< tau_v [s], 0 = off

    /// Declares the entries in subsection Adhesion and binds them to this
    /// object, which must outlive the parsing at the same address.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Does the scene ask for adhesion.
    bool active() const;

    /// Everything a law with penalty needs; throws ExcParameter. Silent
    /// without adhesion.
    void check() const;

    /// As check(), but for the penalty: for formulations that do without.
    void check_without_penalty() const;

    /// The law; only where active().
    AdhesionLaw law() const;
  };
} // namespace demold

#endif

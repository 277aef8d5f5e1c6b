// SPDX-License-Identifier: LGPL-2.1-or-later
// The section "Adhesion" of a parameter file.
#include "adhesion/adhesion_parameters.h"

#include "base/parameter_error.h"

#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    std::string text(const double number)
    {
      std::ostringstream out;
      out << number;
      return out.str();
    }

    void require_positive(const std::string &entry,
                          const double       value,
                          const std::string &unit,
                          const std::string &advice)
    {
      if (!(value > 0. && std::isfinite(value)))
        throw ExcParameter("Adhesion/" + entry,
                           "must be above 0" + unit + "; got " + text(value) +
                             unit + ". " + advice);
    }

    void require_at_least_zero(const std::string &entry,
                               const double       value,
                               const std::string &unit)
    {
      if (!(value >= 0. && std::isfinite(value)))
        throw ExcParameter("Adhesion/" + entry,
                           "must be at least 0" + unit + "; got " +
                             text(value) + unit + ".");
    }

    void require_one_of(const std::string &entry,
                        const std::string &value,
                        const std::string &first,
                        const std::string &second,
                        const std::string &third)
    {
      if (value != first && value != second && value != third)
        throw ExcParameter("Adhesion/" + entry,
                           "must be one of " + first + "|" + second +
                             (third == second ? "" : "|" + third) + "; got '" +
                             value + "'.");
    }
  } // namespace



  void AdhesionParameters::add_parameters(ParameterHandler &prm)
  {
    using namespace Patterns;
    prm.enter_subsection("Adhesion");
    prm.add_parameter("law",
                      law_name,
                      "how the tension limit falls while the bond opens",
                      Selection("none|linear softening|exponential"));
    prm.add_parameter("strength",
                      strength,
                      "alpha largest tension of the bond [MPa]",
                      Double(0.));
    prm.add_parameter("rupture gap",
                      rupture_gap,
                      "delta gap at which the bond is gone; for exponential "
                      "delta_e, gap over which the limit falls by e [mm]",
                      Double(0.));
    prm.add_parameter("penalty",
                      penalty,
                      "gamma stiffness of the intact bond, 20 to 100 "
                      "strength/rupture gap; numerical only [MPa/mm]",
                      Double(0.));
    prm.add_parameter("tangential coupling",
                      tangential_coupling,
                      "beta_T largest shear over largest tension [-]",
                      Double(0.));
    prm.add_parameter("mixing",
                      mixing,
                      "how shear counts beside opening: G_II/G_I is 1 for "
                      "isotropic (needs tangential coupling 1) and energy, "
                      "beta_T for slip limit, beta_T^2 for proportional",
                      Selection("isotropic|slip limit|energy|proportional"));
    prm.add_parameter("unloading",
                      unloading,
                      "damage: back to the origin; plastic: with slope gamma, "
                      "the anchor is dragged along",
                      Selection("damage|plastic"));
    prm.add_parameter("friction weight",
                      friction_weight,
                      "omega part of the pressure that rubs while bonded: all, "
                      "the damaged fraction, or none before rupture",
                      Selection("full|damaged fraction|after rupture"));
    prm.add_parameter("readhesion pressure",
                      readhesion_pressure,
                      "p_re pressure above which a separated point may stick "
                      "again [MPa]",
                      Double(0.));
    prm.add_parameter("readhesion time",
                      readhesion_time,
                      "t_re how long that pressure must last [s]",
                      Double(0.));
    prm.add_parameter("readhesion efficiency",
                      readhesion_efficiency,
                      "eta_re strength of the new bond over that of the one "
                      "before, 0 switches re-adhesion off [-]",
                      Double(0., 1.));
    prm.add_parameter("viscous time",
                      viscous_time,
                      "tau_v regularisation: while damage grows, a bond "
                      "carries its limit times 1 + tau_v (rate of the gap "
                      "that damage has reached)/rupture gap; 0: none [s]",
                      Double(0.));
    prm.leave_subsection();
  }



  bool AdhesionParameters::active() const
  {
    return law_name != "none";
  }



  void AdhesionParameters::check_without_penalty() const
  {
    require_one_of("law",
                   law_name,
                   "none",
                   LinearSoftening::name,
                   ExponentialSoftening::name);
    if (!active())
      return;

    require_positive("strength",
                     strength,
                     " MPa",
                     "Choose law = none to simulate without adhesion.");
    require_positive("rupture gap",
                     rupture_gap,
                     " mm",
                     "It is 2 G_c/strength for linear softening and "
                     "G_c/strength for exponential.");
    require_positive("tangential coupling",
                     tangential_coupling,
                     "",
                     "Try 0.01 for a bond that hardly resists shear.");
    if (mode_mixing(mixing) == ModeMixing::isotropic &&
        tangential_coupling != 1.)
      throw ExcParameter("Adhesion/tangential coupling",
                         "must be 1 with mixing = isotropic, where it has no "
                         "effect; got " +
                           text(tangential_coupling) +
                           ". Set it to 1, or choose mixing = energy, slip "
                           "limit or proportional.");
    require_one_of("unloading", unloading, "damage", "plastic", "plastic");
    require_one_of("friction weight",
                   friction_weight,
                   "full",
                   "damaged fraction",
                   "after rupture");
    require_at_least_zero("readhesion pressure", readhesion_pressure, " MPa");
    require_at_least_zero("readhesion time", readhesion_time, " s");
    require_at_least_zero("readhesion efficiency", readhesion_efficiency, "");
    if (readhesion_efficiency > 1.)
      throw ExcParameter("Adhesion/readhesion efficiency",
                         "must be at most 1; got " +
                           text(readhesion_efficiency) +
                           ". A new bond is not stronger than the first.");
    require_at_least_zero("viscous time", viscous_time, " s");
    if (viscous_time > 0. && unloading != "damage")
      throw ExcParameter("Adhesion/viscous time",
                         "must be 0 s with unloading = plastic; got " +
                           text(viscous_time) +
                           " s. Choose unloading = damage, or 0.");
  }



  void AdhesionParameters::check() const
  {
    check_without_penalty();
    if (!active())
      return;
    const double least = strength / rupture_gap;
    if (!(penalty > least && std::isfinite(penalty)))
      throw ExcParameter("Adhesion/penalty",
                         "must exceed strength/rupture gap = " + text(least) +
                           " MPa/mm; got " + text(penalty) +
                           " MPa/mm. Take 20 to 100 times that, " +
                           text(20. * least) + " to " + text(100. * least) +
                           " MPa/mm, or raise the rupture gap.");
  }



  AdhesionLaw AdhesionParameters::law() const
  {
    AdhesionLaw law;
    if (law_name == ExponentialSoftening::name)
      law.softening = ExponentialSoftening{strength, rupture_gap, penalty};
    else
      law.softening = LinearSoftening{strength, rupture_gap, penalty};
    law.factors = mode_factors(mode_mixing(mixing), tangential_coupling);
    if (unloading == "plastic")
      law.unloading = AdhesionUnloading::plastic;
    if (friction_weight == "damaged fraction")
      law.friction = FrictionWeight::damaged_fraction;
    else if (friction_weight == "after rupture")
      law.friction = FrictionWeight::after_rupture;
    law.rest_pressure   = readhesion_pressure;
    law.rest_time       = readhesion_time;
    law.rest_efficiency = readhesion_efficiency;
    law.viscous_time    = viscous_time;
    return law;
  }
} // namespace demold

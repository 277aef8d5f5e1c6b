// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections Contact, Friction and Adhesion of a parameter file.
#include "scene/interface_parameters.h"

#include "base/parameter_error.h"
#include "scene/expression.h"

#include <deal.II/base/parameter_handler.h>

#include <memory>

namespace demold
{
  using namespace dealii;

  void InterfaceParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Contact");
    prm.add_parameter("formulation",
                      formulation,
                      "how touching surfaces are paired: node to segment by "
                      "penalties, or mortar by multipliers",
                      Patterns::Selection("none|node to segment|mortar"));
    prm.add_parameter("penalty",
                      penalty,
                      "c_N pressure per penetration of node to segment "
                      "[MPa/mm]",
                      Patterns::Double(1e-12));
    prm.add_parameter("search distance",
                      search_distance,
                      "largest gap at which a node looks for a facet [mm]",
                      Patterns::Double(1e-12));
    prm.add_parameter("augmentation",
                      augmentation,
                      "c_N of mortar: no result depends on it; 0: chosen from "
                      "the stiffness of rubber and bond [MPa/mm]",
                      Patterns::Double(0.));
    prm.add_parameter("multipliers",
                      multipliers,
                      "of mortar: standard, shaped as the displacements, or "
                      "dual, biorthogonal to them",
                      Patterns::Selection("standard|dual"));
    prm.add_parameter("condensed",
                      condensed,
                      "dual multipliers on a rigid mould are eliminated node "
                      "by node: a smaller system; supports on the slave take "
                      "no traction there, see Limits in README.md");
    prm.add_parameter("quadrature order",
                      quadrature_order,
                      "degree that the points on a mortar segment integrate "
                      "exactly [-]",
                      Patterns::Integer(2, 5));
    prm.leave_subsection();
    prm.enter_subsection("Friction");
    prm.add_parameter("coefficient",
                      friction,
                      "mu of Coulomb; 0: no friction [-]",
                      Patterns::Double(0.));
    prm.add_parameter("penalty",
                      friction_penalty,
                      "c_T shear per elastic slip [MPa/mm]",
                      Patterns::Double(1e-12));
    prm.leave_subsection();
    adhesion.add_parameters(prm);
    prm.enter_subsection("Adhesion");
    prm.add_parameter("bonded where",
                      bonded,
                      "formula in x, y, z at the start [mm]; bonds form only "
                      "where it is positive [-]");
    prm.add_parameter("bonds form",
                      bonds_form,
                      "at the start, where surfaces meet then; or on touch, "
                      "for node to segment: after every increment where they "
                      "are pressed together for the first time",
                      Patterns::Selection("at the start|on touch"));
    prm.leave_subsection();
  }

  void InterfaceParameters::check_mortar(const std::string &element) const
  {
    adhesion.check_without_penalty();
    if (element == "q2")
      throw ExcParameter("Contact/formulation",
                         "mortar needs element = q1 or q1p0; got q2. Choose "
                         "one of them, or node to segment.");
    if (!adhesion.active())
      return;
    if (bonds_form != "at the start")
      throw ExcParameter("Adhesion/bonds form",
                         "must be at the start with Contact/formulation = "
                         "mortar; got " +
                           bonds_form +
                           ". Choose at the start, or node to segment.");
    if (adhesion.unloading != "damage")
      throw ExcParameter("Adhesion/unloading",
                         "must be damage with Contact/formulation = mortar; "
                         "got " +
                           adhesion.unloading +
                           ". Choose damage, or node to segment.");
    if (adhesion.viscous_time > 0.)
      throw ExcParameter("Adhesion/viscous time",
                         "must be 0 s with Contact/formulation = mortar, whose "
                         "bonds know no viscosity; got " +
                           std::to_string(adhesion.viscous_time) +
                           " s. Choose 0, or node to segment.");
    const double least = adhesion.strength / adhesion.rupture_gap;
    if (augmentation > 0. && augmentation <= least)
      throw ExcParameter("Contact/augmentation",
                         "must exceed the steepest softening of the bond, " +
                           std::to_string(least) + " MPa/mm; got " +
                           std::to_string(augmentation) +
                           " MPa/mm. Take 10 times that, or 0.");
  }

  void InterfaceParameters::check(const std::string &element) const
  {
    if (is_mortar())
      check_mortar(element);
    else
      adhesion.check();
    Expression(bonded, "Adhesion/bonded where");
    if (!active() && adhesion.active())
      throw ExcParameter("Adhesion/law",
                         "needs Contact/formulation other than none; got "
                         "Contact/formulation = none and Adhesion/law = " +
                           adhesion.law_name + ". Set one of them.");
    if (!active() && friction > 0.)
      throw ExcParameter("Friction/coefficient",
                         "needs Contact/formulation other than none; got "
                         "Contact/formulation = none and a coefficient of " +
                           std::to_string(friction) + ". Set one of them.");
  }

  InterfaceDescription
  InterfaceParameters::description(const PlaneModel &plane,
                                   const double      stiffness) const
  {
    InterfaceDescription result;
    result.augmentation     = augmentation;
    result.stiffness        = stiffness;
    result.dual_multipliers = multipliers == "dual";
    result.condensed        = condensed;
    result.quadrature_order = quadrature_order;
    result.penalty          = penalty;
    result.search_distance  = search_distance;
    result.skin             = .5 * search_distance;
    result.friction         = friction;
    result.friction_penalty = friction_penalty;
    result.plane            = plane;
    result.bonds_on_touch   = bonds_form == "on touch";
    if (adhesion.active())
      result.adhesion = adhesion.law();
    const auto where =
      std::make_shared<Expression>(bonded, "Adhesion/bonded where");
    result.bonded = [where](const Point<3> &X) { return (*where)(0., X) > 0.; };
    return result;
  }
} // namespace demold

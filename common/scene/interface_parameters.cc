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
                      "how touching surfaces are paired",
                      Patterns::Selection("none|node to segment"));
    prm.add_parameter("penalty",
                      penalty,
                      "c_N pressure per penetration [MPa/mm]",
                      Patterns::Double(1e-12));
    prm.add_parameter("search distance",
                      search_distance,
                      "largest gap at which a node looks for a facet [mm]",
                      Patterns::Double(1e-12));
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
                      "formula in x, y, z [mm]; bonded at the start where it "
                      "is positive [-]");
    prm.leave_subsection();
  }

  void InterfaceParameters::check() const
  {
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
  InterfaceParameters::description(const PlaneModel &plane) const
  {
    InterfaceDescription result;
    result.penalty          = penalty;
    result.search_distance  = search_distance;
    result.skin             = .5 * search_distance;
    result.friction         = friction;
    result.friction_penalty = friction_penalty;
    result.plane            = plane;
    if (adhesion.active())
      result.adhesion = adhesion.law();
    const auto where =
      std::make_shared<Expression>(bonded, "Adhesion/bonded where");
    result.bonded = [where](const Point<3> &X) { return (*where)(0., X) > 0.; };
    return result;
  }
} // namespace demold

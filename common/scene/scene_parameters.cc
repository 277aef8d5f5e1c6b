// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of a parameter file that all scenes share.
#include "scene/scene_parameters.h"

#include "base/parameter_error.h"

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace demold
{
  using namespace dealii;

  void SceneParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("dimension",
                      dimension,
                      "of the mesh: 2 (plane strain), 3, or axisymmetric "
                      "about the y axis with x = R",
                      Patterns::Selection("2|3|axisymmetric"));
    prm.add_parameter("thickness",
                      thickness,
                      "of a plane-strain slice; forces and energies are "
                      "multiplied by it [mm]",
                      Patterns::Double(1e-12));
    prm.add_parameter("element",
                      element,
                      "q1: bilinear; q1p0: bilinear with mean dilatation, "
                      "free of volumetric locking; q2: biquadratic",
                      Patterns::Selection("q1|q1p0|q2"));
    material.add_parameters(prm);
    prm.enter_subsection("Material");
    prm.add_parameter("cure",
                      cure_kind,
                      "where f90 comes from: uniform or function, both from "
                      "the entry f90, which alone decides for \"by f90\"; "
                      "vulcanised: computed from sections Press and Cure",
                      Patterns::Selection(
                        "by f90|uniform|function|vulcanised"));
    prm.leave_subsection();
    press.add_parameters(prm);
    cure.add_parameters(prm);
    interface.add_parameters(prm);
    add_solution(prm);
    prm.enter_subsection("Output");
    prm.add_parameter("fields every",
                      fields_every,
                      "increments between ParaView files; 0: none [-]",
                      Patterns::Integer(0));
    prm.add_parameter("checkpoint every",
                      checkpoint_every,
                      "increments between checkpoints; 0: none [-]",
                      Patterns::Integer(0));
    prm.leave_subsection();
  }

  void SceneParameters::add_solution(ParameterHandler &prm)
  {
    prm.enter_subsection("Solution");
    prm.add_parameter(
      "strategy",
      strategy,
      "how the scene is solved; automatic: quasi-static, small "
      "jumps along the path, large ones by dynamics; explicit dynamics: central "
      "differences in steps below the critical one",
      Patterns::Selection("quasi-static|dynamics|arc length|"
                          "automatic|explicit dynamics"));
    increments.add_parameters(prm);
    path.add_parameters(prm);
    integrator.add_parameters(prm);
    explicit_dynamics.add_parameters(prm);
    prm.add_parameter("accuracy",
                      accuracy,
                      "eta displacement error of a dynamic step over the "
                      "rupture gap (fast: 0.1) [-]",
                      Patterns::Double(1e-6, 10.));
    prm.leave_subsection();
    prm.enter_subsection("Solver");
    newton.add_parameters(prm);
    linear_solver.add_parameters(prm);
    prm.leave_subsection();
  }

  void SceneParameters::check() const
  {
    material.check();
    check_cure();
    interface.check(element);
    increments.check();
    linear_solver.check();
    check_inertia();
    check_regularisation();
  }

  void SceneParameters::check_regularisation() const
  {
    if (strategy == "arc length" && damage_is_viscous())
      throw ExcParameter("Adhesion/viscous time",
                         "must be 0 s with Solution/strategy = arc length: no "
                         "time passes where a path runs back, so damage would "
                         "stand still and the path with it; got " +
                           std::to_string(interface.adhesion.viscous_time) +
                           " s. Choose 0, or quasi-static.");
  }

  bool SceneParameters::damage_is_viscous() const
  {
    return interface.adhesion.active() && interface.adhesion.viscous_time > 0.;
  }

  void SceneParameters::check_inertia() const
  {
    if (has_inertia() && !(material.density > 0.))
      throw ExcParameter("Material/density",
                         "must be positive for Solution/strategy = " +
                           strategy + "; got " +
                           std::to_string(material.density) + " t/mm^3.");
    if (is_explicit() && interface.is_mortar())
      throw ExcParameter("Contact/formulation",
                         "must be node to segment or none for "
                         "Solution/strategy = explicit dynamics, as "
                         "multipliers have no mass; got mortar. Take "
                         "node to segment, or dynamics.");
  }

  bool SceneParameters::has_inertia() const
  {
    return strategy == "dynamics" || strategy == "automatic" || is_explicit();
  }

  void SceneParameters::check_cure() const
  {
    if (cure_kind == "uniform" && !material.f90_is_uniform())
      throw ExcParameter("Material/cure",
                         "must be function where Material/f90 is a formula; "
                         "got uniform with f90 = " +
                           material.f90_expression() + ".");
    if (!vulcanised())
      return;
    if (dimension == "axisymmetric")
      throw ExcParameter("Material/cure",
                         "must be uniform or function for dimension = "
                         "axisymmetric; got vulcanised, which conducts heat in "
                         "a slice or in 3-D.");
    press.check();
    cure.check();
  }

  RubberLaw SceneParameters::typical_law() const
  {
    return material.at(material.f90_is_uniform() ? material.uniform_f90() :
                                                   material.f90_range().second);
  }

  LinearSolverParameters SceneParameters::linear_solver_of_scene() const
  {
    LinearSolverParameters result = linear_solver;
    if (interface.is_mortar())
      result.relative_tolerance = std::min(result.relative_tolerance, 1e-4);
    if (strategy == "arc length" && result.linear == "auto")
      result.linear = "direct";
    return result;
  }

  int SceneParameters::dim() const
  {
    return dimension == "3" ? 3 : 2;
  }

  PlaneModel SceneParameters::plane() const
  {
    PlaneModel model;
    model.axisymmetric = dimension == "axisymmetric";
    model.thickness    = model.axisymmetric ? 1. : thickness;
    return model;
  }
} // namespace demold

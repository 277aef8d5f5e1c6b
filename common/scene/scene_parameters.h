// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of a parameter file that all scenes share.
#ifndef demold_scene_scene_parameters_h
#define demold_scene_scene_parameters_h

#include "base/plane_model.h"
#include "cure/cure_parameters.h"
#include "cure/press_parameters.h"
#include "material/rubber_model.h"
#include "scene/interface_parameters.h"
#include "solution/explicit_parameters.h"
#include "solution/inertia.h"
#include "solution/linear_solver.h"
#include "solution/nonlinear_solver.h"
#include "solution/path_parameters.h"
#include "solution/strategy.h"

#include <string>

namespace demold
{
  /// Everything but geometry and motion: what the rubber is, what acts at the
  /// interface, how it is solved, what is written.
  struct SceneParameters
  {
    std::string dimension = "2"; ///< 2 | 3 | axisymmetric
    double      thickness = 1.;  ///< [mm] of a 2-D slice
    std::string element   = "q1p0";

    RubberModel            material;
    std::string            cure_kind = "by f90"; ///< where f90 comes from
    CureParameters         cure;                 ///< if vulcanised, as the next
    PressParameters        press;
    InterfaceParameters    interface;
    std::string            strategy = "quasi-static";
    IncrementParameters    increments;
    PathParameters         path;
    TimeIntegrator         integrator;
    ExplicitParameters     explicit_dynamics;
    double                 accuracy = .01; ///< eta of the dynamic step rule
    NewtonParameters       newton;
    LinearSolverParameters linear_solver;

    unsigned int fields_every     = 10; ///< increments; 0: never
    unsigned int checkpoint_every = 50; ///< increments; 0: never

    /// Entries before and after those of the geometry, in printing order.
    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;

    /// Is f90 computed from a press cycle?
    bool vulcanised() const
    {
      return cure_kind == "vulcanised";
    }

    bool damage_is_viscous() const;

    /// Do nodes have mass: dynamics, now or when it is needed?
    bool has_inertia() const;

    bool is_explicit() const
    {
      return strategy == "explicit dynamics";
    }

    /// The rubber in its uniform state of cure, else in the hardest.
    RubberLaw typical_law() const;

    /// Section Solver, linear part. Rows of condensed multipliers mix forces
    /// with gaps: loosely solved they would set the wrong points free. Beyond a
    /// limit point the tangent is indefinite, so that auto is direct there.
    LinearSolverParameters linear_solver_of_scene() const;

    /// 2 or 3.
    int        dim() const;
    PlaneModel plane() const;

  private:
    void add_solution(dealii::ParameterHandler &prm);
    void check_cure() const;
    void check_inertia() const;
    void check_regularisation() const;
  };
} // namespace demold

#endif

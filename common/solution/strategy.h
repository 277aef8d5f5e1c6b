// SPDX-License-Identifier: LGPL-2.1-or-later
// What every solution strategy takes and gives back.
#ifndef demold_solution_strategy_h
#define demold_solution_strategy_h

#include "solution/nonlinear_solver.h"
#include "solution/stability_monitor.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Where the control of increments stands; part of a checkpoint.
  struct IncrementState
  {
    double dt      = 0.; ///< [s] next increment, 0 at the start
    double last_dt = 0.; ///< [s] last one, 0 if nothing to extrapolate from
    unsigned int rejected          = 0; ///< increments, so far
    unsigned int newton_iterations = 0; ///< so far, also of rejected increments
    std::vector<double> path; ///< where the strategy stands; empty: nowhere

    /// All but the path, for checkpoints.
    std::vector<double> save() const;
    void                load(const std::vector<double> &values);
  };

  /// Increments of time, section Solution. Zero means: chosen by the scene.
  struct IncrementParameters
  {
    double       first    = 0.; ///< [s]
    double       smallest = 0.; ///< [s]
    double       largest  = 0.; ///< [s]
    double       growth   = 1.5;
    unsigned int easy     = 5; ///< iterations up to which increments grow

    IncrementState *state = nullptr; ///< kept by the caller

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;
  };

  /// What is special about a point of a path.
  struct PathPoint
  {
    /// static path: behind the clock, out of reach of the machine; envelope:
    /// what the machine sees; jump: where it comes back to the clock.
    std::string      kind;
    std::string      constraint;    ///< by which it was found
    double           clock    = 0.; ///< [s] latest time so far
    double           released = 0.; ///< [mJ] by the excursion that ends here
    double           damped   = 0.; ///< [mJ] in dashpots, by a slide down
    StabilityReading stability;
  };

  /// One accepted increment.
  struct IncrementRecord
  {
    double       time; ///< [s]
    double       dt;   ///< [s]
    NewtonReport newton;
    std::string  strategy;
    unsigned int rejected; ///< so far

    std::optional<PathPoint> path; ///< of path following only

    unsigned int steps = 1; ///< of the time integration that it sums up
  };

  /// Called after each accepted increment; false ends the run.
  using OnAccept = std::function<bool(const IncrementRecord &)>;

  /// How a strategy ended. Rejected increments and iterations are those since
  /// the start of the run, with those before a restart.
  struct StrategyResult
  {
    bool         gave_up = false;
    std::string  reason;
    unsigned int increments        = 0;
    unsigned int rejected          = 0;
    unsigned int newton_iterations = 0;

    /// What was chosen and why, in the order of events.
    std::vector<std::string> events;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Equilibrium along its path, also where time has to go back.
#ifndef demold_solution_path_following_h
#define demold_solution_path_following_h

#include "solution/path_parameters.h"
#include "solution/strategy.h"

namespace demold
{
  class LinearSolver;
  class WeakForm;

  /// What path following works with. `note` is told what is chosen and why.
  struct PathTools
  {
    NonlinearSolver                         &newton;
    LinearSolver                            &linear_solver;
    NewtonParameters                         newton_parameters;
    PathParameters                           path;
    std::function<void(const std::string &)> note = [](const std::string &) {};
  };

  /// Follows the equilibrium of @p weak_form to @p end_time (theory D.2). Time
  /// is a parameter of the path: it says where supports, mould and loads are,
  /// and may go back. In the load phase it goes forward, as in quasi-statics;
  /// a step that fails, or releases more than it may, has met a limit: the
  /// onset of softening is located and the path phase begins, in which a
  /// constraint measures the step. It ends when no point is about to soften.
  ///
  /// The clock of the material is the latest time so far: an excursion back
  /// and forth takes no time at all.
  StrategyResult run_path_following(WeakForm                  &weak_form,
                                    const PathTools           &tools,
                                    const IncrementParameters &increments,
                                    const double               end_time,
                                    const OnAccept            &on_accept);
} // namespace demold

#endif

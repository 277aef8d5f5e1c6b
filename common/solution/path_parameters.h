// SPDX-License-Identifier: LGPL-2.1-or-later
// What path following is asked for.
#ifndef demold_solution_path_parameters_h
#define demold_solution_path_parameters_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Entries of section Solution that belong to `strategy = arc length`; the
  /// second one also to `automatic`.
  struct PathParameters
  {
    /// load, cylindrical, interface, dissipation, largest opening, adaptive
    std::string constraint = "adaptive";

    /// dtau_max: energy a step may release over that of one point [-]
    double release = .5;

    bool monitor = false; ///< read the signs of the pivots at every point?

    bool eigenvalue = false; ///< and the smallest eigenvalue?

    bool branch = false; ///< leave the path at bifurcations?

    void add_parameters(dealii::ParameterHandler &prm);
  };
} // namespace demold

#endif

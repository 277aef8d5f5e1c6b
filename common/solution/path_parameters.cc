// SPDX-License-Identifier: LGPL-2.1-or-later
// What path following is asked for.
#include "solution/path_parameters.h"

#include <deal.II/base/parameter_handler.h>

namespace demold
{
  using namespace dealii;

  void PathParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("path constraint",
                      constraint,
                      "of an arc length: what measures a step along the path "
                      "where time cannot; load: nothing, the path jumps; "
                      "adaptive: chosen as the run goes on",
                      Patterns::Selection(
                        "load|cylindrical|interface|dissipation|largest "
                        "opening|adaptive"));
    prm.add_parameter("released per step",
                      release,
                      "dtau_max largest energy a step along a path may "
                      "release, over what one point releases from first to "
                      "last [-]",
                      Patterns::Double(1e-4, 1.));
    prm.add_parameter("stability monitor",
                      monitor,
                      "of an arc length: factorise the tangent at every point "
                      "of the path and count its negative pivots");
    prm.add_parameter("smallest eigenvalue",
                      eigenvalue,
                      "of an arc length: stability monitor, and the eigenvalue "
                      "of the tangent nearest to zero [N/mm], some ten "
                      "solutions each; not with mortar");
    prm.add_parameter(
      "branch at bifurcations",
      branch,
      "of an arc length: smallest eigenvalue; where the tangent "
      "has two or more negative ones only points that the "
      "eigenvector opens go on softening; not with friction or "
      "mortar");
  }
} // namespace demold

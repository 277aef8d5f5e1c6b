// SPDX-License-Identifier: LGPL-2.1-or-later
// What explicit dynamics is asked for.
#include "solution/explicit_parameters.h"

#include <deal.II/base/parameter_handler.h>

namespace demold
{
  using namespace dealii;

  void ExplicitParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("safety factor",
                      safety,
                      "dt/dt_c of explicit dynamics, dt_c = 2/omega of the "
                      "highest frequency; unstable above 1 [-]",
                      Patterns::Double(1e-3, 2.));
    prm.add_parameter("mass scaling",
                      mass_scaling,
                      "factor on the density in explicit dynamics: steps "
                      "become longer by its root, kinetic energies larger [-]",
                      Patterns::Double(1e-6, 1e12));
  }
} // namespace demold

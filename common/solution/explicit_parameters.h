// SPDX-License-Identifier: LGPL-2.1-or-later
// What explicit dynamics is asked for.
#ifndef demold_solution_explicit_parameters_h
#define demold_solution_explicit_parameters_h

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Entries of section Solution that belong to `strategy = explicit
  /// dynamics`.
  struct ExplicitParameters
  {
    double safety       = .9; ///< step over the critical one [-]
    double mass_scaling = 1.; ///< on the density [-]

    void add_parameters(dealii::ParameterHandler &prm);
  };
} // namespace demold

#endif

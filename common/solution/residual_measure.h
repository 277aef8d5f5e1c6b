// SPDX-License-Identifier: LGPL-2.1-or-later
// How large a residual is, beside the forces and beside round-off.
#ifndef demold_solution_residual_measure_h
#define demold_solution_residual_measure_h

namespace demold
{
  class WeakForm;

  /// |R| over the largest of bulk, interface and inertia forces, of at least
  /// 1e-4 of @p largest_force [N], less what round-off leaves: 1e-14 |K| |u|
  /// (theory D.4). Of one increment.
  class ResidualMeasure
  {
  public:
    /// After an assembly, with the matrix or without.
    double operator()(const WeakForm &weak_form,
                      const double    largest_force,
                      const bool      with_tangent);

  private:
    double round_off    = 0.;  ///< [N]
    double largest_sane = -1.; ///< [N] round-off that is believed
  };
} // namespace demold

#endif

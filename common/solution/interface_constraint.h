// SPDX-License-Identifier: LGPL-2.1-or-later
// Path constraint: a length in the space of the gaps that drive the softening.
#ifndef demold_solution_interface_constraint_h
#define demold_solution_interface_constraint_h

#include "solution/path_constraint.h"

#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <map>

namespace demold
{
  /// c = (sum w_A |dg_A|^2 - s^2)/(2 s) [mm], dg the change of the gap vector
  /// since t_n, w_A = A_A/sum A over the driven points, which are chosen anew
  /// for every step (thesis 6.1; theory D.2 (A)). The predictor asks
  /// for d . dg = s with d the changes in the last step; for a point that has
  /// none, or that would close, the direction in which it opens. A full step
  /// is the gap over which a point softens.
  class InterfaceConstraint : public PathConstraint
  {
  public:
    std::string name() const override;
    void        start(const WeakForm &, const double size) override;
    double      value(const WeakForm &, const unsigned int) const override;
    void        add_gradient(const WeakForm &,
                             const unsigned int,
                             Vector &) const override;
    double      tolerance() const override;
    void        accepted(const WeakForm &) override;

  private:
    using Key = dealii::types::global_dof_index;

    dealii::Tensor<1, 3> along(const SofteningSite &point,
                               const unsigned int   iteration) const;

    double s    = 0.; ///< [mm]
    double area = 0.; ///< [mm^2] of the driven points

    /// Directions of the predictor and changes of the last step, by the first
    /// unknown of a point.
    std::map<Key, dealii::Tensor<1, 3>> direction, last_change;
    double                              length = 1.; ///< of the directions
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Path constraint: one point always opens.
#ifndef demold_solution_largest_opening_constraint_h
#define demold_solution_largest_opening_constraint_h

#include "solution/path_constraint.h"

namespace demold
{
  /// c = max over driven points of (effective gap - largest one up to t_n),
  /// less s [mm] (Lorentz and Badel 2004; theory D.2 (D), (E)). The point is
  /// chosen anew in every iteration. A full step is the gap over which such a
  /// point softens, and no more than what the least damaged one has left.
  class LargestOpeningConstraint : public PathConstraint
  {
  public:
    std::string name() const override;
    void        start(const WeakForm &, const double size) override;
    double      value(const WeakForm &, const unsigned int) const override;
    void        add_gradient(const WeakForm &,
                             const unsigned int,
                             Vector &) const override;
    double      tolerance() const override;

  private:
    double s = 0.; ///< [mm]
  };
} // namespace demold

#endif

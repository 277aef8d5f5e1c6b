// SPDX-License-Identifier: LGPL-2.1-or-later
// Path constraint: how much energy the softening points release in a step.
#ifndef demold_solution_dissipation_constraint_h
#define demold_solution_dissipation_constraint_h

#include "solution/path_constraint.h"

namespace demold
{
  /// c = sum over points of what they release since t_n, less dtau [mJ]
  /// (theory D.2 (B)). For linear softening it is linear in the decohesion
  /// gap. A full step is what one driven point releases altogether, and no
  /// more than what the driven points have left: the last step of a point ends
  /// at its rupture. The sign follows by itself: nothing gives energy back.
  class DissipationConstraint : public PathConstraint
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
    double step = 0.; ///< dtau [mJ]
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Path constraint: a length in the space of all free unknowns.
#ifndef demold_solution_cylindrical_constraint_h
#define demold_solution_cylindrical_constraint_h

#include "solution/path_constraint.h"

namespace demold
{
  /// c = (|du|^2 - s^2)/(2 s) [mm] with du = u - u_n, free unknowns alone
  /// (Crisfield 1981 without the load). The predictor goes on in the direction
  /// of the last step, d . du = s with d = du_n/|du_n|: it never turns back,
  /// and Newton stays on its side, so that there is no root to choose. A full
  /// step is `length`, which the caller sets after the first step.
  class CylindricalConstraint : public PathConstraint
  {
  public:
    std::string name() const override;
    void        start(const WeakForm &, const double size) override;
    double      value(const WeakForm &, const unsigned int) const override;
    void        add_gradient(const WeakForm &,
                             const unsigned int,
                             Vector &) const override;
    double      tolerance() const override;

    double length = 0.; ///< [mm]

  private:
    double s = 0.; ///< [mm]
    Vector direction;
  };

  /// u - u_n with the prescribed entries zero.
  Vector free_increment(const WeakForm &weak_form);
} // namespace demold

#endif

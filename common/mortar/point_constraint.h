// SPDX-License-Identifier: LGPL-2.1-or-later
// The constraint of one multiplier in space: gap = G(augmented traction).
#ifndef demold_mortar_point_constraint_h
#define demold_mortar_point_constraint_h

#include "adhesion/newton_rules.h"

#include <deal.II/base/tensor.h>

#include <optional>
#include <vector>

namespace demold
{
  /// What the constraint of a point depends on.
  struct ConstraintInput
  {
    dealii::Tensor<1, 3> gap;      ///< [mm] per area: g_N n + g_T
    dealii::Tensor<1, 3> normal;   ///< unit, out of the slave
    dealii::Tensor<1, 3> traction; ///< lambda [MPa], tension positive

    /// [mm] gap vector at t_n of a point whose bond holds, else 0, less
    /// compliance sprung of t_n; its tangential part replaces the slip of the
    /// history.
    dealii::Tensor<1, 3> old_gap;

    /// Whether the point is pressed, where the sign of lambda_N + c_N g_N is
    /// not to decide. lambda_hat_N of a point that is to be pressed is
    /// lambda_N: what is left of its gap, times a large c_N, would open it.
    std::optional<bool> pressed;

    /// [mm/MPa] by component, where the constraint alone would leave the
    /// multiplier undetermined, else 0: a spring in series, so that the law
    /// sees g - compliance sprung.
    dealii::Tensor<1, 3> compliance;
    /// [MPa] lambda, or its difference from others that do not depend on it.
    dealii::Tensor<1, 3> sprung;

    /// Branch that a path asks for; it comes before the rules of Newton.
    std::optional<ForcedBranch> forced;
  };

  /// What of it the law sees.
  struct SeenByLaw
  {
    dealii::Tensor<1, 3> gap;       ///< [mm] without what is sprung
    dealii::Tensor<1, 3> augmented; ///< lambda_hat [MPa]
    AugmentedTraction    traction;  ///< the same by parts
    ResolventState       old;       ///< its slip in the present plane
  };

  SeenByLaw seen_by_law(const TractionResolvent &resolvent,
                        const ConstraintInput   &input,
                        const ResolventState    &old);

  /// Residual r = g - compliance sprung - G(lambda_hat) [mm] (theory C9) and
  /// its derivatives; vectors are Cartesian.
  struct ConstraintResponse
  {
    dealii::Tensor<1, 3> residual;
    dealii::Tensor<2, 3> dgap;      ///< [-]
    dealii::Tensor<2, 3> dtraction; ///< [mm/MPa] also through sprung
    dealii::Tensor<2, 3> dsprung;   ///< [mm/MPa] at a given lambda
    dealii::Tensor<2, 3> dnormal;   ///< [mm]
    ResolventResponse    law;
  };

  ConstraintResponse point_constraint(const TractionResolvent &resolvent,
                                      const ConstraintInput   &input,
                                      const ResolventState    &old,
                                      const NewtonMemory      &last);

  /// Factor [MPa/mm] that makes of the residual @p stiffness [MPa/mm] times the
  /// gap where it is one, and lambda where it is lambda/c_N, so that rows are
  /// of one size whatever c_N is: ((1 - dgap)/c_N + dgap/stiffness)^-1, for c_N
  /// = stiffness the c_N of theory C9. Only rows and columns in
  /// @p components take part.
  dealii::Tensor<2, 3> row_scaling(const dealii::Tensor<2, 3>      &dgap,
                                   const double                     c_N,
                                   const double                     stiffness,
                                   const std::vector<unsigned int> &components);

  /// Derivative of scaling * @p residual by the normal, @p response being that
  /// of the same point [-]. Under pressure the scaling turns with the normal:
  /// without that, what is left of the gap of a closed point, times c_N, would
  /// be a shear of the first iterations.
  dealii::Tensor<2, 3> scaled_dnormal(const ConstraintResponse   &response,
                                      const dealii::Tensor<2, 3> &scaling,
                                      const dealii::Tensor<1, 3> &residual,
                                      const dealii::Tensor<1, 3> &normal);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// A multiplier that Newton does not see, followed through its iterations.
#ifndef demold_mortar_eliminated_multiplier_h
#define demold_mortar_eliminated_multiplier_h

#include "weak_form/algebra.h"
#include "weak_form/assembler.h"

#include <deal.II/base/tensor.h>

#include <vector>

namespace demold
{
  /// lambda + offset + dlambda/du (u_now - u): what the linear solution has
  /// implied for a multiplier eliminated from the last linear system.
  class EliminatedMultiplier
  {
  public:
    /// Begins an increment with this value [MPa].
    void restart(const dealii::Tensor<1, 3> &lambda);

    /// [MPa] at the displacements @p now.
    dealii::Tensor<1, 3> value(const Vector &now) const;

    /// Keeps a linearisation at @p now: dlambda/du [MPa/mm] of the unknowns
    /// @p columns.
    void remember(const dealii::Tensor<1, 3>              &lambda,
                  const dealii::Tensor<1, 3>              &offset,
                  const Assembler::Indices                &columns,
                  const std::vector<dealii::Tensor<1, 3>> &dlambda,
                  const Vector                            &now);

  private:
    dealii::Tensor<1, 3>              at, offset; ///< [MPa]
    Assembler::Indices                columns;
    std::vector<double>               u;    ///< [mm]
    std::vector<dealii::Tensor<1, 3>> by_u; ///< [MPa/mm]
  };
} // namespace demold

#endif

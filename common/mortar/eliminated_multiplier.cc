// SPDX-License-Identifier: LGPL-2.1-or-later
// A multiplier that Newton does not see, followed through its iterations.
#include "mortar/eliminated_multiplier.h"

namespace demold
{
  using dealii::Tensor;

  void EliminatedMultiplier::restart(const Tensor<1, 3> &lambda)
  {
    at      = lambda;
    offset  = Tensor<1, 3>();
    columns = {};
    u.clear();
    by_u.clear();
  }

  Tensor<1, 3> EliminatedMultiplier::value(const Vector &now) const
  {
    Tensor<1, 3> lambda = at + offset;
    for (unsigned int k = 0; k < columns.size(); ++k)
      lambda += (now(columns[k]) - u[k]) * by_u[k];
    return lambda;
  }

  void EliminatedMultiplier::remember(const Tensor<1, 3>       &lambda,
                                      const Tensor<1, 3>       &new_offset,
                                      const Assembler::Indices &new_columns,
                                      const std::vector<Tensor<1, 3>> &dlambda,
                                      const Vector                    &now)
  {
    at      = lambda;
    offset  = new_offset;
    columns = new_columns;
    by_u    = dlambda;
    u.clear();
    for (const auto column : columns)
      u.push_back(now(column));
  }
} // namespace demold

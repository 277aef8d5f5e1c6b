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

  void EliminatedMultiplier::remember(const Tensor<1, 3>  &lambda,
                                      const Tensor<1, 3>  &new_offset,
                                      const NodalUnknowns &unknowns,
                                      const std::vector<Tensor<2, 3>> &change,
                                      const Vector                    &now)
  {
    at      = lambda;
    offset  = new_offset;
    columns = unknowns.indices;
    u.clear();
    by_u.clear();
    for (unsigned int k = 0; k < columns.size(); ++k)
      {
        u.push_back(now(columns[k]));
        Tensor<1, 3> column;
        for (unsigned int i = 0; i < 3; ++i)
          column[i] =
            change[unknowns.entries[k] / 3][i][unknowns.entries[k] % 3];
        by_u.push_back(column);
      }
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Element matrices on their way into the system.
#include "weak_form/assembler.h"

#include <algorithm>

namespace demold
{
  using namespace dealii;

  void SystemAssembler::add(const Indices                &indices,
                            const dealii::Vector<double> &r,
                            const FullMatrix<double>     &K)
  {
    residual.add(indices, r);
    const bool constrained =
      std::any_of(indices.begin(), indices.end(), [this](const auto i) {
        return constraints.is_constrained(i);
      });
    if (!constrained && inserter.add(*matrix, indices, K, weight))
      return;

    scaled = K;
    scaled *= weight;
    if (inhomogeneous)
      {
        // Only the elimination of prescribed increments lands here; the
        // residual itself is added by the weak form.
        zero.reinit(indices.size());
        constraints.distribute_local_to_global(scaled,
                                               zero,
                                               indices,
                                               *matrix,
                                               right_hand_side,
                                               true);
      }
    else
      constraints.distribute_local_to_global(scaled, indices, *matrix);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Closed-form update, stress, tangent and energies of Lubliner's flow rule.
#include "material/lubliner_branch.h"

#include "material/fading_memory.h"
#include "material/overstress.h"

#include <algorithm>

namespace demold
{
  namespace
  {
    /// @p B is C_i^-1, @p K is C^-1.
    Overstress overstress(const Six &C, const Six &K, const Six &B)
    {
      const Six  lag = difference(C, inverse(B));
      const Nine X   = product(lag, B);
      // tr[(b_e - 1)^2 b_e^-1] = (C - C_i) : (C_i^-1 - C^-1)
      return Overstress::with_volume(X, contract(lag, difference(B, K)));
    }
  } // namespace

  void LublinerBranch::add(const BranchStep &step,
                           const double     *B_old,
                           double           *B_new,
                           ResponseSums     &sums) const
  {
    const double        h = step.dt / relaxation_time;
    const MemoryWeights w = memory_weights(h);

    Six before;
    std::copy(B_old, B_old + 6, before.begin());
    Six B = scaled(before, w.old);
    add_scaled(B, w.start, step.K_old);
    add_scaled(B, w.end, step.x.K);
    std::copy(B.begin(), B.end(), B_new);

    add_scaled(sums.S, modulus, difference(B, step.x.K));

    // 2 dS/dC = 2 mu (1 - w_1) K(.)K
    if (step.with_tangent)
      sums.K_square += 2. * modulus * (w.old + w.start);

    if (step.with_energies)
      {
        const Overstress start = overstress(step.C_old, step.K_old, before);
        const Overstress end   = overstress(step.x.C, step.x.K, B);
        sums.stored += .5 * modulus * end.energy;
        sums.dissipated += modulus * dissipation_over_step(start, end, h);
      }
  }
} // namespace demold

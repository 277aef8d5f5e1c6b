// SPDX-License-Identifier: LGPL-2.1-or-later
// Closed-form update, stress, tangent and energies of linear evolution.
#include "material/linear_branch.h"

#include "material/fading_memory.h"
#include "material/overstress.h"

#include <algorithm>

namespace demold
{
  namespace
  {
    Overstress overstress(const Six &C, const Six &Ci, const Six &Ci_inverse)
    {
      const Nine X = product(difference(C, Ci), Ci_inverse);
      return Overstress::with_volume(X, trace_of_product(X, X));
    }
  } // namespace

  void LinearBranch::add(const BranchStep &step,
                         const double     *Ci_old,
                         double           *Ci_new,
                         ResponseSums     &sums) const
  {
    const double        h = step.dt / relaxation_time;
    const MemoryWeights w = memory_weights(h);

    Six before;
    std::copy(Ci_old, Ci_old + 6, before.begin());
    Six Ci = scaled(before, w.old);
    add_scaled(Ci, w.start, step.C_old);
    add_scaled(Ci, w.end, step.x.C);
    std::copy(Ci.begin(), Ci.end(), Ci_new);

    const Six B = inverse(Ci);
    add_scaled(sums.S, modulus, difference(B, step.x.K));

    if (step.with_tangent)
      {
        // 2 dB/dC = -2 w_1 B(.)B
        sums.add_rest(B, 0., -2. * modulus * w.end);
        sums.K_square += 2. * modulus;
      }

    if (step.with_energies)
      {
        const Overstress start =
          overstress(step.C_old, before, inverse(before));
        const Overstress end = overstress(step.x.C, Ci, B);
        sums.stored += .5 * modulus * end.energy;
        sums.dissipated += modulus * dissipation_over_step(start, end, h);
      }
  }
} // namespace demold

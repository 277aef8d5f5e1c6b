// SPDX-License-Identifier: LGPL-2.1-or-later
// Closed-form update, stress, tangent and dissipation of an isochoric branch.
#include "material/maxwell_branch.h"

#include "material/fading_memory.h"
#include "material/overstress.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  namespace
  {
    /// Of C_i,n, Cbar_n and Cbar_n+1 (A9); @p phi = Cbar_n : C_i,n^-1 / 3 >= 1
    /// is used by EXP2 only.
    MemoryWeights weights(const ViscousUpdate update,
                          const double        h,
                          double              phi)
    {
      // Only the ratio of the weights matters.
      if (update == ViscousUpdate::be)
        return {1. / (1. + h), 0., h / (1. + h)};
      if (update == ViscousUpdate::lin)
        return memory_weights(h);
      const MemoryWeights w = memory_weights(phi * h);
      return {w.old, w.start / phi, w.end / phi};
    }
  } // namespace

  void MaxwellBranch::add(const ViscousStep &step,
                          const double      *Ci_old,
                          double            *Ci_new,
                          ResponseSums      &sums) const
  {
    Six A;
    std::copy(Ci_old, Ci_old + 6, A.begin());
    const Six    Ci_old_inverse = adjugate(A);
    const double h              = step.dt / relaxation_time;

    // The sum is unimodular again once divided by a = det(A)^(1/3).
    const MemoryWeights w =
      weights(step.update, h, contract(step.Cbar_old, Ci_old_inverse) / 3.);
    A = scaled(A, w.old);
    add_scaled(A, w.start, step.Cbar_old);
    add_scaled(A, w.end, step.Cbar);

    const Six    adj_A = adjugate(A);
    const double det_A = determinant(A, adj_A);
    const double a     = std::cbrt(det_A);
    const Six    G     = scaled(adj_A, 1. / det_A);
    for (unsigned int i = 0; i < 6; ++i)
      Ci_new[i] = A[i] / a;

    const double p = step.x.p, trace = a * contract(step.Cbar, G);
    add_scaled(sums.S, modulus * p * a, G);
    add_scaled(sums.S, -modulus * trace / 3., step.x.K);

    if (step.with_tangent)
      {
        // (A10) with the contraction (GxG/3 - G(.)G):(I - CxC^-1/3) by hand:
        // V = G Cbar G - (Cbar:G)/3 G collects what meets C^-1.
        Six V = symmetric_product(G, product(step.Cbar, G));
        add_scaled(V, -trace / (3. * a), G);
        const double wa = w.end * a, f = 2. * modulus * p;

        sums.KK += 2. / 9. * modulus * (trace - wa * contract(step.Cbar, V));
        sums.K_square += 2. / 3. * modulus * trace;
        add_scaled(sums.U, -f / 3. * a, G);
        add_scaled(sums.U, f / 3. * wa, V);
        sums.add_rest(G, f * p * wa / 3., -f * p * wa);
      }

    if (step.with_energies)
      {
        const Overstress start(product(step.Cbar_old, Ci_old_inverse));
        const Overstress end(product(step.Cbar, scaled(G, a)));
        sums.stored += .5 * modulus * end.energy;
        sums.dissipated += modulus * dissipation_over_step(start, end, h);
      }
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Closed-form update, stress, tangent and dissipation of a Maxwell branch.
#include "material/maxwell_branch.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  namespace
  {
    /// A = old Ci_n + start Cbar_n + end Cbar_n+1, all weights >= 0.
    struct Weights
    {
      double old, start, end;
    };

    /// Weights of linear interpolation in time under exponential decay:
    /// e = exp(-h), q = (1-e)/h; returns {e, q-e, 1-q}.
    Weights exponential_weights(const double h)
    {
      const double e_less_one = std::expm1(-h);
      const double e          = 1. + e_less_one;
      if (h < 5e-3)
        return {e,
                h * (1. / 2. - h * (1. / 3. - h * (1. / 8. - h / 30.))),
                h * (1. / 2. - h * (1. / 6. - h * (1. / 24. - h / 120.)))};
      const double q = -e_less_one / h;
      return {e, q - e, 1. - q};
    }

    /// (A9); @p phi = Cbar_n : C_i,n^-1 / 3 >= 1 is used by EXP2 only.
    Weights weights(const ViscousUpdate update, const double h, double phi)
    {
      // Only the ratio of the weights matters.
      if (update == ViscousUpdate::be)
        return {1. / (1. + h), 0., h / (1. + h)};
      if (update == ViscousUpdate::lin)
        return exponential_weights(h);
      const Weights w = exponential_weights(phi * h);
      return {w.old, w.start / phi, w.end / phi};
    }
  } // namespace

  Overstress::Overstress(const Nine &product)
    : M(product)
  {
    const double trace = product[0] + product[4] + product[8];
    for (const unsigned int i : {0, 4, 8})
      M[i] -= trace / 3.;
    square = trace_of_product(M, M);
    energy = trace - 3.;
    // Near equilibrium the difference above loses its digits. From
    // det(M + trace/3 1) = 1 follows an expansion that does not.
    if (square < 1e-6)
      energy = .5 * square - determinant(M);
    square = std::max(square, 0.);
    energy = std::max(energy, 0.);
  }

  double dissipation_over_step(const Overstress &start,
                               const Overstress &end,
                               const double      h)
  {
    const auto rate_factor = [](const Overstress &x) {
      return x.energy > 0. ? .5 * x.square / x.energy : 1.;
    };
    const double H = .5 * h * (rate_factor(start) + rate_factor(end));

    const double x0x0 = start.energy, x1x1 = end.energy;
    double       x0x1 = 0.;
    if (start.square > 0. && end.square > 0.)
      {
        const double cosine = trace_of_product(start.M, end.M) /
                              std::sqrt(start.square * end.square);
        x0x1 = std::max(-1., std::min(1., cosine)) * std::sqrt(x0x0 * x1x1);
      }

    if (H < 2e-2)
      {
        const double even = H / 3. + H * H * H / 180.;
        const double odd  = H * H / 12. - H * H * H * H / 720.;
        return (even - odd) * x0x0 + (H / 3. - H * H * H / 90.) * x0x1 +
               (even + odd) * x1x1;
      }
    const double p     = -std::expm1(-H);
    const double E     = 1. - p;
    const double alpha = .5 * p * (1. + E) - 2. * E * p + E * E * H;
    const double beta  = (1. + E) * p - 2. * E * H;
    const double gamma = .5 * p * (1. + E) - 2. * p + H;
    return std::max(0., (alpha * x0x0 + beta * x0x1 + gamma * x1x1) / (p * p));
  }

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
    const Weights w =
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

// SPDX-License-Identifier: LGPL-2.1-or-later
// Closed-form update, stress and tangent of the stress convolution.
#include "material/convolution_branches.h"

#include "material/elastic_laws.h"
#include "material/fading_memory.h"

namespace demold
{
  namespace
  {
    /// The isochoric law of shear modulus @p G at @p x.
    ResponseSums isochoric(const Deformation &x,
                           const double       G,
                           const double       share_of_I2,
                           const bool         with_tangent)
    {
      ResponseSums sums;
      IsochoricMooneyRivlin{.5 * G * (1. - share_of_I2),
                            .5 * G * share_of_I2,
                            0.}
        .add(x, with_tangent, sums);
      return sums;
    }
  } // namespace

  void ConvolutionBranches::add(const BranchStep                 &step,
                                const std::vector<MaxwellBranch> &branches,
                                const double                     *H_old,
                                double                           *H_new,
                                ResponseSums                     &sums) const
  {
    const Six rise =
      difference(isochoric(step.x, 1., share_of_I2, false).S,
                 isochoric(Deformation(step.C_old), 1., share_of_I2, false).S);

    double stiffness = 0.;
    Six    sum_old{{}}, sum_new{{}};
    for (const MaxwellBranch &branch : branches)
      {
        const MemoryWeights w =
          memory_weights(step.dt / branch.relaxation_time);
        const double mu_q = branch.modulus * (w.old + w.start);
        for (unsigned int i = 0; i < 6; ++i)
          {
            H_new[i] = w.old * H_old[i] + mu_q * rise[i];
            sum_old[i] += H_old[i];
            sum_new[i] += H_new[i];
          }
        stiffness += mu_q;
        H_old += 6;
        H_new += 6;
      }
    add_scaled(sums.S, 1., sum_new);

    if (step.with_tangent)
      {
        const ResponseSums part =
          isochoric(step.x, stiffness, share_of_I2, true);
        sums.one += part.one;
        sums.KK += part.KK;
        sums.K_square += part.K_square;
        add_scaled(sums.U, 1., part.U);
      }

    // S : dC/2
    if (step.with_energies)
      {
        add_scaled(sum_new, 1., sum_old);
        sums.dissipated +=
          .25 * contract(sum_new, difference(step.x.C, step.C_old));
      }
  }
} // namespace demold

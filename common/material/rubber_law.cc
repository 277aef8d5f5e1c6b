// SPDX-License-Identifier: LGPL-2.1-or-later
// The sum over the elastic law and the Maxwell branches.
#include "material/rubber_law.h"

#include "material/convolution_branches.h"
#include "material/linear_branch.h"
#include "material/lubliner_branch.h"

#include <algorithm>

namespace demold
{
  using namespace dealii;

  namespace
  {
    double young(const double K, const double G)
    {
      return 9. * K * G / (3. * K + G);
    }

    double poisson(const double K, const double G)
    {
      return (3. * K - 2. * G) / (2. * (3. * K + G));
    }

    /// Adds the branches one by one; the histories begin at the first of them.
    template <typename Branch, typename Step>
    void add_each(const std::vector<MaxwellBranch> &branches,
                  const Step                       &step,
                  const double                     *old_history,
                  double                           *new_history,
                  ResponseSums                     &sums)
    {
      for (const MaxwellBranch &branch : branches)
        {
          Branch{branch.modulus, branch.relaxation_time}.add(step,
                                                             old_history,
                                                             new_history,
                                                             sums);
          old_history += 6;
          new_history += 6;
        }
    }
  } // namespace

  void RubberLaw::initialize(double *history) const
  {
    std::fill_n(history, n_history(), 0.);
    const unsigned int n_metrics = branch_law == BranchLaw::convolution ?
                                     std::min(n_history(), 6u) :
                                     n_history();
    for (unsigned int i = 0; i < n_metrics; i += 6)
      std::copy(six_identity.begin(), six_identity.end(), history + i);
  }

  void RubberLaw::evaluate(const SymmetricTensor<2, 3> &C,
                           const double                 dt,
                           const double                *old_history,
                           double                      *new_history,
                           const bool                   with_tangent,
                           BulkResponse                &out,
                           const bool                   with_energies) const
  {
    Six C_entries;
    std::copy(C.begin_raw(), C.begin_raw() + 6, C_entries.begin());
    const Deformation x(C_entries);

    ResponseSums sums;
    std::visit([&](const auto &law) { law.add(x, with_tangent, sums); },
               elastic);

    if (!branches.empty() && branch_law == BranchLaw::isochoric)
      {
        ViscousStep step{x,
                         scaled(x.C, x.p),
                         {{}},
                         dt,
                         update,
                         with_tangent,
                         with_energies};
        std::copy(old_history, old_history + 6, step.Cbar_old.begin());
        std::copy(step.Cbar.begin(), step.Cbar.end(), new_history);
        add_each<MaxwellBranch>(branches,
                                step,
                                old_history + 6,
                                new_history + 6,
                                sums);
      }
    else if (!branches.empty())
      {
        BranchStep step{x, {{}}, {{}}, dt, with_tangent, with_energies};
        std::copy(old_history, old_history + 6, step.C_old.begin());
        step.K_old = inverse(step.C_old);
        std::copy(x.C.begin(), x.C.end(), new_history);
        old_history += 6;
        new_history += 6;
        if (branch_law == BranchLaw::linear)
          add_each<LinearBranch>(branches,
                                 step,
                                 old_history,
                                 new_history,
                                 sums);
        else if (branch_law == BranchLaw::lubliner)
          add_each<LublinerBranch>(branches,
                                   step,
                                   old_history,
                                   new_history,
                                   sums);
        else
          ConvolutionBranches{
            std::visit([](const auto &law) { return law.share_of_I2(); },
                       elastic)}
            .add(step, branches, old_history, new_history, sums);
      }

    std::copy(sums.S.begin(), sums.S.end(), out.S.begin_raw());
    if (with_energies)
      {
        out.stored     = sums.stored;
        out.dissipated = sums.dissipated;
      }
    if (with_tangent)
      sums.write_tangent(x.K, out.dS_dE.begin_raw());
  }

  double RubberLaw::shear_modulus_relaxed() const
  {
    return std::visit([](const auto &law) { return law.shear_modulus(); },
                      elastic);
  }

  double RubberLaw::shear_modulus_instantaneous() const
  {
    double G = shear_modulus_relaxed();
    for (const MaxwellBranch &branch : branches)
      G += branch.modulus;
    return G;
  }

  double RubberLaw::bulk_modulus() const
  {
    return std::visit([](const auto &law) { return law.bulk_modulus(); },
                      elastic);
  }

  double RubberLaw::bulk_modulus_instantaneous() const
  {
    double K = bulk_modulus();
    if (branch_law == BranchLaw::linear || branch_law == BranchLaw::lubliner)
      for (const MaxwellBranch &branch : branches)
        K += 2. / 3. * branch.modulus;
    return K;
  }

  double RubberLaw::young_relaxed() const
  {
    return young(bulk_modulus(), shear_modulus_relaxed());
  }

  double RubberLaw::young_instantaneous() const
  {
    return young(bulk_modulus_instantaneous(), shear_modulus_instantaneous());
  }

  double RubberLaw::poisson_relaxed() const
  {
    return poisson(bulk_modulus(), shear_modulus_relaxed());
  }

  double RubberLaw::poisson_instantaneous() const
  {
    return poisson(bulk_modulus_instantaneous(), shear_modulus_instantaneous());
  }
} // namespace demold

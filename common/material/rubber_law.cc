// SPDX-License-Identifier: LGPL-2.1-or-later
// The sum over the elastic law and the Maxwell branches.
#include "material/rubber_law.h"

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
  } // namespace

  void RubberLaw::initialize(double *history) const
  {
    for (unsigned int i = 0; i < n_history(); i += 6)
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

    if (!branches.empty())
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
        for (const MaxwellBranch &branch : branches)
          {
            old_history += 6;
            new_history += 6;
            branch.add(step, old_history, new_history, sums);
          }
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

  double RubberLaw::young_relaxed() const
  {
    return young(bulk_modulus(), shear_modulus_relaxed());
  }

  double RubberLaw::young_instantaneous() const
  {
    return young(bulk_modulus(), shear_modulus_instantaneous());
  }

  double RubberLaw::poisson_relaxed() const
  {
    return poisson(bulk_modulus(), shear_modulus_relaxed());
  }

  double RubberLaw::poisson_instantaneous() const
  {
    return poisson(bulk_modulus(), shear_modulus_instantaneous());
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Rubber at one point: elastic law and Maxwell branches in parallel.
#ifndef demold_material_rubber_law_h
#define demold_material_rubber_law_h

#include "material/belt_ply.h"
#include "material/branch_law.h"
#include "material/elastic_laws.h"
#include "material/maxwell_branch.h"

#include <deal.II/base/symmetric_tensor.h>

#include <variant>
#include <vector>

namespace demold
{
  /// What the rubber answers at t_n+1.
  struct BulkResponse
  {
    dealii::SymmetricTensor<2, 3> S;     ///< 2nd Piola-Kirchhoff stress [MPa]
    dealii::SymmetricTensor<4, 3> dS_dE; ///< algorithmic tangent 2 dS/dC [MPa]
    double stored     = 0.; ///< elastic law and branches, at t_n+1 [mJ/mm^3]
    double dissipated = 0.; ///< viscous, over the step [mJ/mm^3]; >= 0 but for
                            ///< BranchLaw::convolution
  };

  /// Rubber of one degree of cure (theory A6): a value. The history of a point
  /// is six doubles of where it was and six of each branch, in the order 00,
  /// 11, 22, 01, 02, 12; an elastic law has none:
  ///   isochoric    Cbar_n and C_i      linear       C_n and C_i
  ///   lubliner     C_n and C_i^-1      convolution  C_n and H [MPa]
  /// The branches of `isochoric` and `convolution` answer no change of volume,
  /// those of the other two do (see LinearBranch).
  struct RubberLaw
  {
    std::variant<MooneyRivlin, IsochoricMooneyRivlin, BeltPly> elastic;
    std::vector<MaxwellBranch>                                 branches;
    BranchLaw     branch_law = BranchLaw::isochoric;
    ViscousUpdate update     = ViscousUpdate::exp2; ///< of `isochoric` alone
    double        density    = 1.12e-9; ///< in the reference state [t/mm^3]

    /// Doubles per point.
    unsigned int n_history() const
    {
      return branches.empty() ? 0 : 6 + 6 * branches.size();
    }

    /// Stress free and at rest, undeformed.
    void initialize(double *history) const;

    /// Response to the right Cauchy-Green tensor @p C [-] after a step of
    /// length @p dt [s] >= 0; with @p dt = 0 the dashpots are rigid. Writes all
    /// of @p new_history, which may not be @p old_history; both may be null
    /// where n_history() is 0. Without @p with_tangent, dS_dE is untouched;
    /// without @p with_energies (a third of the time with many branches),
    /// stored and dissipated are: a Newton iteration does not need them.
    /// det C must be positive; it does not show an inverted F, the caller does.
    void evaluate(const dealii::SymmetricTensor<2, 3> &C,
                  double                               dt,
                  const double                        *old_history,
                  double                              *new_history,
                  bool                                 with_tangent,
                  BulkResponse                        &out,
                  bool with_energies = true) const;

    /// Small-strain constants; `relaxed`: slow, the dashpots free;
    /// `instantaneous`: fast, the dashpots rigid; bulk_modulus() is relaxed
    /// [MPa].
    double shear_modulus_relaxed() const;
    double shear_modulus_instantaneous() const;
    double bulk_modulus() const;
    double bulk_modulus_instantaneous() const;
    double young_relaxed() const;
    double young_instantaneous() const;

    /// Poisson's ratio at small strain [-].
    double poisson_relaxed() const;
    double poisson_instantaneous() const;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// The relaxation equations of the Maxwell branches, before any time stepping.
#ifndef demold_rig_flow_rule_h
#define demold_rig_flow_rule_h

#include "material/rubber_law.h"

#include <deal.II/base/symmetric_tensor.h>

namespace demold
{
  /// Stress and evolution of a law at a state that is given, not stepped to
  /// (theory A.2): written from the equations alone, as the reference of the
  /// updates of RubberLaw. The inner variable A of a branch is
  ///   isochoric C_i, linear C_i, lubliner C_i^-1,
  ///   convolution the part of S_iso that has been forgotten.
  class FlowRule
  {
  public:
    explicit FlowRule(const RubberLaw &law);

    /// At one C, for all branches.
    struct Point
    {
      dealii::SymmetricTensor<2, 3> C, C_inverse, C_bar; ///< [-]
      dealii::SymmetricTensor<2, 3> S_elastic; ///< of the elastic law [MPa]

      /// Of the isochoric law with shear modulus 1; convolution only [-].
      dealii::SymmetricTensor<2, 3> S_isochoric;
    };

    Point at(const dealii::SymmetricTensor<2, 3> &C) const;

    /// dA/dt [1/s] of branch @p j.
    dealii::SymmetricTensor<2, 3> rate(const Point                         &x,
                                       const dealii::SymmetricTensor<2, 3> &A,
                                       unsigned int j) const;

    /// 2nd Piola-Kirchhoff stress of branch @p j [MPa].
    dealii::SymmetricTensor<2, 3> stress(const Point                         &x,
                                         const dealii::SymmetricTensor<2, 3> &A,
                                         unsigned int j) const;

    /// A of a branch at rest.
    dealii::SymmetricTensor<2, 3> relaxed(const Point &x) const;

    unsigned int n_branches() const
    {
      return branches.size();
    }

    double bulk_modulus() const ///< instantaneous [MPa]
    {
      return bulk;
    }

  private:
    std::vector<MaxwellBranch> branches;
    BranchLaw                  branch_law;
    double                     bulk;
    RubberLaw                  elastic, isochoric; // without branches
  };
} // namespace demold

#endif

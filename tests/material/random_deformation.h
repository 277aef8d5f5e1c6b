// SPDX-License-Identifier: LGPL-2.1-or-later
// Deformations and histories for the tests of the rubber.
#ifndef demold_tests_material_random_deformation_h
#define demold_tests_material_random_deformation_h

#include "material/rubber_law.h"

#include <deal.II/base/tensor.h>

#include <random>
#include <vector>

namespace demold
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  inline SymmetricTensor<2, 3> right_cauchy_green(const Tensor<2, 3> &F)
  {
    return symmetrize(transpose(F) * F);
  }

  /// Simple shear: F = 1 + gamma e1 x e2.
  inline Tensor<2, 3> simple_shear(const double gamma)
  {
    Tensor<2, 3> F(dealii::unit_symmetric_tensor<3>());
    F[0][1] = gamma;
    return F;
  }

  inline Tensor<2, 3> stretches(const double a, const double b, const double c)
  {
    Tensor<2, 3> F;
    F[0][0] = a;
    F[1][1] = b;
    F[2][2] = c;
    return F;
  }

  /// F = 1 + size (a random matrix with entries between -1 and 1).
  inline Tensor<2, 3> random_gradient(std::mt19937 &generator,
                                      const double  size)
  {
    std::uniform_real_distribution<double> entry(-size, size);
    Tensor<2, 3> F(dealii::unit_symmetric_tensor<3>());
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        F[i][j] += entry(generator);
    return F;
  }

  /// A rubber point with its own history, moved step by step.
  struct Point
  {
    RubberLaw           law;
    std::vector<double> history;
    BulkResponse        response;

    explicit Point(const RubberLaw &law)
      : law(law)
      , history(law.n_history())
    {
      law.initialize(history.data());
    }

    const BulkResponse &move_to(const Tensor<2, 3> &F, const double dt)
    {
      const std::vector<double> old = history;
      law.evaluate(right_cauchy_green(F),
                   dt,
                   old.data(),
                   history.data(),
                   true,
                   response);
      return response;
    }

    /// Kirchhoff stress F S F^T [MPa] of the last step.
    Tensor<2, 3> kirchhoff(const Tensor<2, 3> &F) const
    {
      return F * Tensor<2, 3>(response.S) * transpose(F);
    }
  };

  /// A branch law with, if it is isochoric, its update.
  struct Variant
  {
    const char   *name;
    BranchLaw     branch_law;
    ViscousUpdate update;
  };

  /// All that section Material offers.
  constexpr Variant all_variants[] = {
    {"V1 EXP2", BranchLaw::isochoric, ViscousUpdate::exp2},
    {"V1 BE", BranchLaw::isochoric, ViscousUpdate::be},
    {"V1 LIN", BranchLaw::isochoric, ViscousUpdate::lin},
    {"V2", BranchLaw::linear, ViscousUpdate::exp2},
    {"V3", BranchLaw::lubliner, ViscousUpdate::exp2},
    {"V4", BranchLaw::convolution, ViscousUpdate::exp2}};

  /// One branch mu = 1 MPa, tau = 1 s beside an elastic law that carries
  /// nothing, so that stress and energies are the branch's own.
  inline RubberLaw bare_branch(const ViscousUpdate update)
  {
    RubberLaw law;
    law.elastic  = MooneyRivlin{0., 0., 0.};
    law.branches = {{1., 1.}};
    law.update   = update;
    return law;
  }

  inline RubberLaw bare_branch(const Variant &variant)
  {
    RubberLaw law  = bare_branch(variant.update);
    law.branch_law = variant.branch_law;
    return law;
  }
} // namespace demold

#endif

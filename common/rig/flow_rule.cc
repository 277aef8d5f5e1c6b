// SPDX-License-Identifier: LGPL-2.1-or-later
// The relaxation equations of the Maxwell branches, before any time stepping.
#include "rig/flow_rule.h"

#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    SymmetricTensor<2, 3> stress_of(const RubberLaw             &elastic,
                                    const SymmetricTensor<2, 3> &C)
    {
      BulkResponse response;
      elastic.evaluate(C, 0., nullptr, nullptr, false, response, false);
      return response.S;
    }
  } // namespace



  FlowRule::FlowRule(const RubberLaw &law)
    : branches(law.branches)
    , branch_law(law.branch_law)
    , bulk(law.bulk_modulus_instantaneous())
    , elastic(law)
  {
    elastic.branches.clear();
    const double r =
      std::visit([](const auto &e) { return e.share_of_I2(); }, law.elastic);
    isochoric.elastic = IsochoricMooneyRivlin{.5 * (1. - r), .5 * r, 0.};
  }

  FlowRule::Point FlowRule::at(const SymmetricTensor<2, 3> &C) const
  {
    Point x;
    x.C         = C;
    x.C_inverse = invert(C);
    x.C_bar     = std::pow(determinant(C), -1. / 3.) * C;
    x.S_elastic = stress_of(elastic, C);
    if (branch_law == BranchLaw::convolution)
      x.S_isochoric = stress_of(isochoric, C);
    return x;
  }



  SymmetricTensor<2, 3> FlowRule::rate(const Point                 &x,
                                       const SymmetricTensor<2, 3> &A,
                                       const unsigned int           j) const
  {
    const double tau = branches[j].relaxation_time;
    switch (branch_law)
      {
        case BranchLaw::isochoric:
          return (x.C_bar - x.C_bar * invert(A) / 3. * A) / tau;
        case BranchLaw::linear:
          return (x.C - A) / tau;
        case BranchLaw::lubliner:
          return (x.C_inverse - A) / tau;
        default:
          return (x.S_isochoric - A) / tau;
      }
  }

  SymmetricTensor<2, 3> FlowRule::stress(const Point                 &x,
                                         const SymmetricTensor<2, 3> &A,
                                         const unsigned int           j) const
  {
    const double mu = branches[j].modulus;
    switch (branch_law)
      {
        case BranchLaw::isochoric:
          {
            const SymmetricTensor<2, 3> B = invert(A);
            return mu * std::pow(determinant(x.C), -1. / 3.) *
                   (B - x.C * B / 3. * x.C_inverse);
          }
        case BranchLaw::linear:
          return mu * (invert(A) - x.C_inverse);
        case BranchLaw::lubliner:
          return mu * (A - x.C_inverse);
        default:
          return mu * (x.S_isochoric - A);
      }
  }

  SymmetricTensor<2, 3> FlowRule::relaxed(const Point &x) const
  {
    return branch_law == BranchLaw::isochoric ? x.C_bar :
           branch_law == BranchLaw::linear    ? x.C :
           branch_law == BranchLaw::lubliner  ? x.C_inverse :
                                                x.S_isochoric;
  }
} // namespace demold

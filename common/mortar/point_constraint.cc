// SPDX-License-Identifier: LGPL-2.1-or-later
// The constraint of one multiplier in space: gap = G(augmented traction).
#include "mortar/point_constraint.h"

#include <deal.II/base/symmetric_tensor.h>

namespace demold
{
  using namespace dealii;

  namespace
  {
    const Tensor<2, 3> unit = unit_symmetric_tensor<3>();

    double normal_penalty(const TractionResolvent &resolvent,
                          const ConstraintInput   &input)
    {
      return input.pressed == true ? 0. : resolvent.penalty;
    }

    Tensor<2, 3> compliance_tensor(const ConstraintInput &input)
    {
      Tensor<2, 3> E;
      for (unsigned int d = 0; d < 3; ++d)
        E[d][d] = input.compliance[d];
      return E;
    }

    /// C = diag(c_N, c_T, c_T)
    Tensor<2, 3> augmentation(const TractionResolvent &resolvent,
                              const ConstraintInput   &input)
    {
      const double c_N = normal_penalty(resolvent, input);
      const double c_T = resolvent.tangential_penalty();
      return c_T * unit +
             (c_N - c_T) * outer_product(input.normal, input.normal);
    }

    /// dG/dlambda_hat at a fixed normal.
    Tensor<2, 3> by_traction(const ResolventResponse &law,
                             const Tensor<1, 3>      &n,
                             const Tensor<2, 3>      &tangential)
    {
      const Tensor<1, 3> row = law.dN_dN * n + tangential * law.dN_dT;
      return outer_product(n, row) + outer_product(law.dT_dN, n) +
             law.dT_dT * tangential;
    }

    /// dG/dn at a fixed lambda_hat. A slip direction turns with the plane.
    Tensor<2, 3> by_normal(const ResolventResponse &law,
                           const Tensor<1, 3>      &augmented,
                           const Tensor<1, 3>      &n,
                           const Tensor<2, 3>      &tangential)
    {
      const double       normal_part = augmented * n;
      const Tensor<1, 3> row         = law.dN_dN * augmented -
                               normal_part * (tangential * law.dN_dT) -
                               law.gap_T;
      return law.gap_N * unit + outer_product(n, row) +
             outer_product(law.dT_dN, augmented) -
             normal_part * (law.dT_dT * tangential);
    }
  } // namespace

  SeenByLaw seen_by_law(const TractionResolvent &resolvent,
                        const ConstraintInput   &input,
                        const ResolventState    &old)
  {
    const Tensor<1, 3> &n          = input.normal;
    const Tensor<2, 3>  tangential = unit - outer_product(n, n);
    SeenByLaw           seen;
    seen.gap       = input.gap - compliance_tensor(input) * input.sprung;
    seen.augmented = input.traction + augmentation(resolvent, input) * seen.gap;
    seen.traction  = {seen.augmented * n,
                      tangential * seen.augmented,
                      input.pressed};
    seen.old       = old;
    seen.old.slip  = tangential * input.old_gap;
    return seen;
  }

  ConstraintResponse point_constraint(const TractionResolvent &resolvent,
                                      const ConstraintInput   &input,
                                      const ResolventState    &old,
                                      const NewtonMemory      &last)
  {
    const Tensor<1, 3> &n          = input.normal;
    const double        c_N        = normal_penalty(resolvent, input);
    const double        c_T        = resolvent.tangential_penalty();
    const Tensor<2, 3>  tangential = unit - outer_product(n, n);
    const Tensor<2, 3>  C          = augmentation(resolvent, input);
    const Tensor<2, 3>  E          = compliance_tensor(input);
    const SeenByLaw     seen       = seen_by_law(resolvent, input, old);
    const Tensor<1, 3> &gap        = seen.gap;
    const Tensor<1, 3> &augmented  = seen.augmented;

    ConstraintResponse response;
    response.law =
      input.forced ?
        resolvent.evaluate(seen.traction, seen.old, input.forced) :
        evaluate_by_rules(resolvent, seen.traction, seen.old, last);
    const Tensor<2, 3> dG = by_traction(response.law, n, tangential);
    response.residual     = gap - response.law.gap_N * n - response.law.gap_T;
    response.dgap         = unit - dG * C;
    response.dsprung      = -1. * (response.dgap * E);
    response.dtraction    = response.dsprung - dG;
    const Tensor<2, 3> augmented_by_normal =
      (c_N - c_T) * ((n * gap) * unit + outer_product(n, gap));
    response.dnormal = -1. * by_normal(response.law, augmented, n, tangential) -
                       dG * augmented_by_normal +
                       (n * input.old_gap) * response.law.dT_dslip;
    return response;
  }

  Tensor<2, 3> row_scaling(const Tensor<2, 3>              &dgap,
                           const double                     c_N,
                           const double                     stiffness,
                           const std::vector<unsigned int> &components)
  {
    Tensor<2, 3> a = unit;
    for (const unsigned int i : components)
      for (const unsigned int j : components)
        a[i][j] = unit[i][j] / c_N + dgap[i][j] * (1. / stiffness - 1. / c_N);
    a = invert(a);
    Tensor<2, 3> result;
    for (const unsigned int i : components)
      for (const unsigned int j : components)
        result[i][j] = a[i][j];
    return result;
  }

  Tensor<2, 3> scaled_dnormal(const ConstraintResponse &response,
                              const Tensor<2, 3>       &scaling,
                              const Tensor<1, 3>       &residual,
                              const Tensor<1, 3>       &normal)
  {
    Tensor<2, 3> result = scaling * response.dnormal;
    if (response.law.contact == ContactStatus::open)
      return result;
    // W x as a linear map of dn, W = dn n - n dn turning n by dn
    const auto turned = [&](const Tensor<1, 3> &x) {
      return (normal * x) * unit - outer_product(normal, x);
    };
    result += turned(scaling * residual) - scaling * turned(residual);
    return result;
  }
} // namespace demold

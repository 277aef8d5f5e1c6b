// SPDX-License-Identifier: LGPL-2.1-or-later
// A point without pressure: all rows of the point law with lambda_hat_N > 0.
#include "adhesion/resolvent_branch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demold
{
  using namespace dealii;

  namespace
  {
    // Scaled gap over scaled traction [mm/MPa]: q = ratio p and
    // dq/dp = ratio (1 - m m) + rate m m.
    struct Compliance
    {
      double ratio;
      double rate;
    };



    // p = (lambda_hat_N, b/a lambda_hat_T) of norm size > 0, m = p/|p|, and
    // g = (q_N, q_T/b).
    void set_gap(const AugmentedTraction &traction,
                 const ModeFactors       &factors,
                 const double             size,
                 const Compliance         compliance,
                 ResolventBranch         &branch)
    {
      const auto [ratio, rate] = compliance;
      ResolventResponse &r     = branch.response;
      const double       scale = factors.b / factors.a;
      const double       m_N   = traction.normal / size;
      const Tensor<1, 3> m_T   = scale / size * traction.tangential;

      r.gap_N = ratio * traction.normal;
      r.gap_T = ratio / factors.a * traction.tangential;
      r.dN_dN = ratio + (rate - ratio) * m_N * m_N;
      r.dN_dT = (rate - ratio) * m_N * scale * m_T;
      r.dT_dN = (rate - ratio) * m_N / factors.b * m_T;
      r.dT_dT = (rate - ratio) / factors.a * outer_product(m_T, m_T);
      for (unsigned int d = 0; d < 3; ++d)
        r.dT_dT[d][d] += ratio / factors.a;
      branch.deffective_dN = rate * m_N;
      branch.deffective_dT = rate * scale * m_T;
    }
  } // namespace



  ResolventBranch open_branch(const TractionResolvent          &law,
                              const AugmentedTraction          &traction,
                              const ResolventState             &old,
                              const std::optional<ForcedBranch> forced)
  {
    const ModeFactors factors = law.factors();
    const double      c       = law.penalty;
    const double      size =
      std::max(std::hypot(traction.normal,
                          factors.b / factors.a * traction.tangential.norm()),
               std::numeric_limits<double>::min());
    ResolventBranch branch;
    if (!law.holds(old))
      {
        set_gap(traction, factors, size, {1. / c, 1. / c}, branch);
        return branch;
      }

    const PointSoftening softening{law.adhesion->softening,
                                   old.bond.strength_factor};
    const double         kappa  = old.bond.kappa;
    const double         limit  = softening.at(kappa).limit + c * kappa;
    const RadialGap      radial = radial_gap(softening, c, size);

    const AdhesionStatus elastic =
      kappa > 0. ? AdhesionStatus::unloading : AdhesionStatus::adhering;
    AdhesionStatus free = AdhesionStatus::decohesion;
    if (size <= limit)
      free = elastic;
    else if (radial.gap >= separation_gap(law.adhesion->softening))
      free = AdhesionStatus::separated;

    ResolventResponse &r = branch.response;
    r.bond               = free;
    if (forced == ForcedBranch::hold)
      r.bond = elastic;
    else if (forced == ForcedBranch::decohesion && softening.feels(size))
      r.bond = AdhesionStatus::decohesion;
    r.consistent = r.bond == free;

    Compliance compliance{kappa / limit, kappa / limit};
    r.utilisation = size / limit;
    if (r.bond == AdhesionStatus::decohesion)
      {
        branch.effective = radial.gap;
        compliance       = {radial.gap / size, radial.rate};
        r.utilisation    = 1.;
      }
    if (r.bond == AdhesionStatus::separated)
      {
        compliance    = {1. / c, 1. / c};
        r.utilisation = 0.;
      }
    set_gap(traction, factors, size, compliance, branch);
    return branch;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of the resolvent led along prescribed gaps.
#ifndef demold_tests_adhesion_resolvent_paths_h
#define demold_tests_adhesion_resolvent_paths_h

#include "resolvents.h"

#include <gtest/gtest.h>

namespace demold
{
  /// g_N and g_T.
  struct Gap
  {
    double  opening;
    Vector3 slip;
  };

  inline Gap between(const Gap &x, const Gap &y, const double fraction)
  {
    return {x.opening + fraction * (y.opening - x.opening),
            x.slip + fraction * (y.slip - x.slip)};
  }

  inline double effective_gap(const TractionResolvent &law, const Gap &g)
  {
    return effective_gap(law, g.opening, g.slip);
  }

  /// Traction [MPa] of the bond at a gap, theory C.4; at no gap that of the
  /// onset in the direction of @p towards.
  inline AugmentedTraction bond_traction(const TractionResolvent &law,
                                         const Gap               &gap,
                                         const double             kappa_old,
                                         const Gap               &towards)
  {
    const double kappa = std::max(kappa_old, effective_gap(law, gap));
    const Gap    g     = kappa > 0. ? gap : towards;
    const double over  = kappa > 0. ? kappa : effective_gap(law, towards);
    const double k     = tension_limit(law, kappa) / over;
    return {k * g.opening, k * law.factors().a * g.slip};
  }

  /// Leads a bonded point to @p gap under @p pressure (which needs g_N = 0)
  /// with the traction of the law in closed form; expects that gap back.
  inline ResolventResponse lead_to(const TractionResolvent &law,
                                   const Gap               &gap,
                                   const double             pressure,
                                   const ResolventState    &old)
  {
    AugmentedTraction t = bond_traction(law, gap, old.bond.kappa, gap);
    t.normal -= pressure;
    const Vector3 slide = gap.slip - old.slip;
    if (old.may_stick && slide.norm() > 0.)
      t.tangential += law.friction * pressure / slide.norm() * slide;
    t.normal += law.penalty * gap.opening;
    t.tangential += law.tangential_penalty() * gap.slip;
    const auto r = law.evaluate(t, old);
    EXPECT_NEAR(r.gap_N, gap.opening, 1e-13);
    EXPECT_LT((r.gap_T - gap.slip).norm(), 1e-13);
    return r;
  }
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// The law with penalty tends to the point law with multipliers, and onset and
// forced softening lie next to the limit.
#include "resolvent_paths.h"

namespace demold
{
  using namespace dealii;

  // Newton's method for the traction at a prescribed gap.
  AugmentedTraction traction_at(const TractionResolvent &law,
                                const Gap               &gap,
                                const ResolventState    &old,
                                ResolventResponse       &r)
  {
    AugmentedTraction t{law.penalty * gap.opening + .5 * alpha,
                        law.tangential_penalty() * gap.slip};
    for (unsigned int i = 0; i < 60; ++i)
      {
        r = law.evaluate(t, old);
        const Vector3 missing =
          gap.slip - r.gap_T + (gap.opening - r.gap_N) * up;
        if (missing.norm() < 1e-16)
          break;
        Tensor<2, 3> J =
          r.dT_dT + outer_product(r.dT_dN, up) + outer_product(up, r.dN_dT);
        // An intact point has no slope: one step along the gap.
        if (r.bond == AdhesionStatus::adhering)
          {
            t.normal += .5 * alpha;
            continue;
          }
        for (unsigned int d = 0; d < 2; ++d)
          J[d][2] = r.dT_dN[d], J[2][d] = r.dN_dT[d];
        J[2][2]            = r.dN_dN;
        const Vector3 step = invert(J) * missing;
        t.normal += step * up;
        t.tangential += step - (step * up) * up;
      }
    return multiplier(law, t, r);
  }



  TEST(traction_resolvent_neighbours,
       law_with_penalty_tends_to_it_like_one_by_gamma)
  {
    for (const Curve curve : {Curve::linear, Curve::exponential})
      for (const ModeMixing mixing : all_mixings)
        {
          const auto law  = make_resolvent(curve, mixing, 0., 5.);
          double     last = 0.;
          for (const double gamma : {2e3, 4e3, 8e3, 1.6e4})
            {
              AdhesionLaw with_penalty = *law.adhesion;
              std::visit([&](auto &s) { s.penalty = gamma; },
                         with_penalty.softening);
              ResolventState state = law.fresh_bond();
              AdhesionState  other;
              double         difference = 0.;
              for (const double x : {.1, .3, .6, .2, .4, .7, .5, .8})
                {
                  const Gap         gap{.05 * x * (1.1 - .5 * x),
                                .06 * x * x * vector(.6, .8, 0.)};
                  ResolventResponse r;
                  const auto        lambda = traction_at(law, gap, state, r);
                  const auto        t =
                    with_penalty.evaluate(gap.opening * up + gap.slip,
                                          up,
                                          other);
                  difference = std::max(difference,
                                        (lambda.normal * up +
                                         lambda.tangential - t.traction)
                                          .norm());
                  ASSERT_EQ(r.bond, t.status);
                  state = r.state;
                  other = t.state;
                }
              if (last > 0.)
                {
                  EXPECT_NEAR(last / difference, 2., .05);
                }
              last = difference;
            }
          EXPECT_LT(last, 1e-3 * alpha);
        }
  }



  TEST(traction_resolvent_neighbours, utilisation_is_one_where_softening_begins)
  {
    std::mt19937 engine(31);
    unsigned int met = 0;
    for (const TractionResolvent &law : all_resolvents())
      for (unsigned int i = 0; i < 500; ++i)
        {
          const auto s = random_sample(law, engine);
          if (!law.holds(s.old))
            continue;
          AugmentedTraction in   = s.traction;
          AugmentedTraction out  = random_traction(law, s.normal, engine);
          const auto        soft = [&](const AugmentedTraction &t) {
            return law.evaluate(t, s.old).bond == AdhesionStatus::decohesion;
          };
          if (soft(in) || !soft(out))
            continue;
          for (unsigned int k = 0; k < 60; ++k)
            {
              const AugmentedTraction middle{.5 * (in.normal + out.normal),
                                             .5 * (in.tangential +
                                                   out.tangential)};
              (soft(middle) ? out : in) = middle;
            }
          const auto r = law.evaluate(in, s.old);
          if (r.bond == AdhesionStatus::separated)
            continue;
          ++met;
          ASSERT_NEAR(r.utilisation, 1., 1e-9);
          ASSERT_NEAR(law.evaluate(out, s.old).utilisation, 1., 1e-9);
        }
    EXPECT_GT(met, 500u);
  }



  TEST(traction_resolvent_neighbours, forced_decohesion_goes_on_below_the_limit)
  {
    for (const TractionResolvent &law : all_resolvents())
      for (const double pressure : {-.02, .05})
        {
          // Just below and above the onset of an intact bond, theory D.2.
          const double grip  = pressure > 0. ? law.friction * pressure : 0.;
          const double reach = pressure > 0. ?
                                 alpha :
                                 std::sqrt(alpha * alpha - pressure * pressure);
          const double limit = grip + reach * law.factors().a / law.factors().b;
          const auto   forced = [&](const double share) {
            return law.evaluate({-pressure, share * limit * vector(0., 1., 0.)},
                                law.fresh_bond(),
                                ForcedBranch::decohesion);
          };
          const auto below = forced(.999), above = forced(1.001);
          EXPECT_FALSE(below.consistent);
          EXPECT_TRUE(above.consistent);
          EXPECT_LT(below.path_increment, 0.);
          EXPECT_GT(above.path_increment, 0.);
          EXPECT_NEAR(below.path_increment / above.path_increment, -1., .02);
          EXPECT_EQ(below.state.bond.kappa, 0.);
          EXPECT_LT(below.gap_T[1], 0.);
          EXPECT_GT(below.dpath_dT[1], 0.);
        }
  }
} // namespace demold

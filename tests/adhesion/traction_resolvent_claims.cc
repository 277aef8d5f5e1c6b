// SPDX-License-Identifier: LGPL-2.1-or-later
// What theory C.4 says of single points: limits, no healing, memory, the law
// with penalty as a neighbour.
#include "resolvent_paths.h"

#include <limits>

namespace demold
{
  using namespace dealii;

  TEST(traction_resolvent_claims, slips_at_friction_plus_shear_strength)
  {
    for (const Curve curve : {Curve::linear, Curve::exponential})
      for (const ModeMixing mixing : all_mixings)
        {
          const auto   law      = make_resolvent(curve, mixing, .4, 5.);
          const double pressure = .3;
          const double limit =
            law.friction * pressure + law.factors().a / law.factors().b * alpha;
          const Vector3 e = vector(.8, .6, 0.);
          const auto    below =
            law.evaluate({-pressure, .999 * limit * e}, law.fresh_bond());
          EXPECT_EQ(below.bond, AdhesionStatus::adhering);
          EXPECT_EQ(below.gap_T.norm(), 0.);
          const auto above =
            law.evaluate({-pressure, 1.001 * limit * e}, law.fresh_bond());
          EXPECT_EQ(above.bond, AdhesionStatus::decohesion);
          EXPECT_EQ(above.contact, ContactStatus::slip);
          EXPECT_GT(above.gap_T * e, 0.);
          EXPECT_EQ(above.gap_N, 0.);
        }
  }



  TEST(traction_resolvent_claims, pressure_neither_heals_nor_damages)
  {
    for (const TractionResolvent &law : all_resolvents())
      for (const double pressure : {1e-3, 1., 1e3})
        {
          const auto pressed = law.evaluate({-pressure, {}}, law.fresh_bond());
          EXPECT_EQ(pressed.state.bond.kappa, 0.);
          EXPECT_EQ(pressed.dissipated_increment, 0.);

          const Gap  opened{.02, .01 * vector(1., 0., 0.)};
          const auto damaged = lead_to(law, opened, 0., law.fresh_bond());
          const auto closed  = lead_to(law, {0., {}}, pressure, damaged.state);
          EXPECT_EQ(closed.bond, AdhesionStatus::unloading);
          EXPECT_EQ(closed.state.bond.kappa, damaged.state.bond.kappa);
          EXPECT_EQ(closed.state.bond.dissipated,
                    damaged.state.bond.dissipated);
          // Half way back it pulls half as much as when it was damaged.
          const auto again =
            lead_to(law, between({0., {}}, opened, .5), 0., closed.state);
          EXPECT_EQ(again.bond, AdhesionStatus::unloading);
        }
  }



  TEST(traction_resolvent_claims, closing_point_has_no_friction_at_first)
  {
    TractionResolvent law;
    law.friction              = .4;
    law.penalty               = 50.;
    const Vector3        pull = .1 * vector(1., 0., 0.);
    const ResolventState open;
    const auto           closing = law.evaluate({-1., pull}, open);
    EXPECT_EQ(closing.contact, ContactStatus::closed);
    EXPECT_LT((law.penalty * closing.gap_T - pull).norm(), 1e-16);
    const auto stays = law.evaluate({-1., pull}, closing.state);
    EXPECT_EQ(stays.contact, ContactStatus::closed);
    EXPECT_EQ(stays.gap_T.norm(), 0.);
    const auto opens = law.evaluate({1., {}}, stays.state);
    EXPECT_FALSE(opens.state.may_stick);
  }



  // thesis 2.76, 2.80 with errata E4, E5.
  TEST(traction_resolvent_claims, without_bond_it_is_contact_with_friction)
  {
    std::mt19937      engine(21);
    TractionResolvent law;
    law.friction = .3;
    law.penalty  = 7.;
    EXPECT_EQ(law.smallest_penalty(), 0.);
    EXPECT_EQ(law.tangential_penalty(), law.penalty);
    ResolventState closed;
    closed.may_stick = true;
    for (unsigned int i = 0; i < 1000; ++i)
      {
        const AugmentedTraction t{uniform(engine, -1., 1.),
                                  uniform(engine, 0., .6) *
                                    random_tangent(up, engine)};
        const auto              r      = law.evaluate(t, closed);
        const double            normal = std::min(t.normal, 0.);
        const double            limit  = law.friction * std::abs(normal);
        const double            size   = t.tangential.norm();
        const Vector3 rubbed = std::min(1., limit / size) * t.tangential;
        EXPECT_NEAR(r.gap_N, (t.normal - normal) / law.penalty, 1e-15);
        EXPECT_LT((law.penalty * r.gap_T - (t.tangential - rubbed)).norm(),
                  1e-15);
        EXPECT_EQ(r.number(), t.normal > 0. ? 6 : size > limit ? 5 : 4);
      }
  }



  TEST(traction_resolvent_claims, friction_weight_follows_the_damage)
  {
    auto law = make_resolvent(Curve::linear, ModeMixing::energy, .5, 5.);
    const double   pressure = .2;
    ResolventState half     = law.fresh_bond();
    half.bond.kappa         = .5 * delta;
    const auto slips_from   = [&](const ResolventState &old,
                                const FrictionWeight  weight) {
      law.adhesion->friction = weight;
      double low = 0., high = 10.;
      for (unsigned int i = 0; i < 60; ++i)
        {
          const double pull = .5 * (low + high);
          const auto   r =
            law.evaluate({-pressure, pull * vector(1., 0., 0.)}, old);
          (r.gap_T.norm() > 0. ? high : low) = pull;
        }
      return high;
    };
    const double full = law.friction * pressure;
    EXPECT_NEAR(slips_from(half, FrictionWeight::full), full, 1e-12);
    EXPECT_NEAR(slips_from(half, FrictionWeight::damaged_fraction),
                .5 * full,
                1e-12);
    EXPECT_NEAR(slips_from(half, FrictionWeight::after_rupture), 0., 1e-12);
    ResolventState ruptured = half;
    ruptured.bond.kappa     = delta;
    EXPECT_NEAR(slips_from(ruptured, FrictionWeight::after_rupture),
                full,
                1e-12);
  }



  TEST(traction_resolvent_claims, separated_point_bonds_again_if_pressed)
  {
    auto law = make_resolvent(Curve::linear, ModeMixing::energy, .5, 5.);
    law.adhesion->rest_pressure   = .1;
    law.adhesion->rest_time       = 2.;
    law.adhesion->rest_efficiency = .25;
    const auto gone =
      law.evaluate({10. * law.penalty * delta, {}}, law.fresh_bond());
    EXPECT_EQ(gone.bond, AdhesionStatus::separated);
    EXPECT_FALSE(law.holds(gone.state));
    const auto once = law.rested(gone.state, .2, 1.5);
    EXPECT_FALSE(law.holds(once));
    const auto twice = law.rested(once, .2, 1.5);
    EXPECT_TRUE(law.holds(twice));
    EXPECT_FALSE(law.holds(law.rested(once, .05, 1.5)));
    EXPECT_EQ(law.evaluate({.24 * alpha, {}}, twice).bond,
              AdhesionStatus::adhering);
    EXPECT_EQ(law.evaluate({.26 * alpha, {}}, twice).bond,
              AdhesionStatus::decohesion);
  }



  TEST(traction_resolvent_claims, nothing_is_infinite_at_zero)
  {
    auto laws = all_resolvents();
    laws.push_back(TractionResolvent{{}, .3, 1.});
    for (const TractionResolvent &law : laws)
      for (const double normal : {-1e-300, 0., 1e-300})
        for (ResolventState old : {ResolventState(), law.fresh_bond()})
          for (const double kappa : {0., .01})
            for (const auto forced : {std::optional<ForcedBranch>(),
                                      std::optional(ForcedBranch::hold),
                                      std::optional(ForcedBranch::decohesion)})
              {
                old.bond.kappa = kappa;
                const auto r   = law.evaluate({normal, {}}, old, forced);
                double     sum = r.gap_N + r.dN_dN + r.utilisation + r.stored +
                             r.path_increment + r.dpath_dN +
                             r.dissipated_increment + r.dpath_dT.norm() +
                             r.gap_T.norm() + r.dN_dT.norm() + r.dT_dN.norm() +
                             r.dT_dT.norm() + r.dT_dslip.norm();
                EXPECT_TRUE(std::isfinite(sum)) << normal << " " << kappa;
              }
  }



  TEST(traction_resolvent_claims, damage_next_to_none_or_all_is_rounded)
  {
    const auto law = make_resolvent(Curve::linear, ModeMixing::energy, 0., 5.);
    const auto at  = [&](const double kappa) {
      const double s = alpha * (1. - kappa / delta);
      return law.evaluate({s + law.penalty * kappa, {}}, law.fresh_bond())
        .state;
    };
    EXPECT_EQ(at(.5e-9 * delta).bond.kappa, 0.);
    EXPECT_EQ(at(.5e-9 * delta).bond.dissipated, 0.);
    EXPECT_GT(at(2e-9 * delta).bond.kappa, 0.);
    EXPECT_LT(at((1. - 2e-9) * delta).bond.kappa, delta);
    EXPECT_EQ(at((1. - .5e-9) * delta).bond.kappa, delta);
  }



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



  TEST(traction_resolvent_claims,
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



  TEST(traction_resolvent_claims, utilisation_is_one_where_softening_begins)
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



  TEST(traction_resolvent_claims, forced_decohesion_goes_on_below_the_limit)
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

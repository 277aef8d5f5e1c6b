// SPDX-License-Identifier: LGPL-2.1-or-later
// What theory C.4 says of single points: limits, no healing, memory.
#include "resolvent_paths.h"

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



  TEST(traction_resolvent_claims, held_point_remembers_where_it_sticks)
  {
    // An intact bond in tension is closed all the same; a stretched one not.
    const auto law = make_resolvent(Curve::linear, ModeMixing::energy, .4, 5.);
    const auto pulled = law.evaluate({.5 * alpha, {}}, law.fresh_bond());
    EXPECT_TRUE(pulled.state.may_stick);
    EXPECT_EQ(pulled.number(), 0);
    const auto stretched = lead_to(law, {.02, {}}, 0., law.fresh_bond());
    EXPECT_FALSE(stretched.state.may_stick);
    EXPECT_EQ(stretched.number(), 1);
  }



  TEST(traction_resolvent_claims, friction_keeps_a_stretched_bond_from_onset)
  {
    // At its largest slip ever, held by friction: what is used of the way to
    // softening is what is used of friction.
    const auto law = make_resolvent(Curve::linear, ModeMixing::energy, .4, 5.);
    const double  pressure = .3;
    const Vector3 slip     = .05 * vector(1., 0., 0.);
    const auto    slid = lead_to(law, {0., slip}, pressure, law.fresh_bond());
    EXPECT_EQ(slid.utilisation, 1.);
    const double stiffness = law.factors().a *
                             tension_limit(law, slid.state.bond.kappa) /
                             slid.state.bond.kappa;
    for (const double share : {0., .3, .9})
      {
        const Vector3 rubbing =
          share * law.friction * pressure * vector(1., 0., 0.);
        const auto r = law.evaluate(
          {-pressure, (stiffness + law.tangential_penalty()) * slip + rubbing},
          slid.state);
        EXPECT_EQ(r.bond, AdhesionStatus::unloading);
        EXPECT_EQ(r.contact, ContactStatus::closed);
        EXPECT_EQ(r.number(), 2);
        EXPECT_NEAR(r.utilisation, share, 1e-12);
      }
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
} // namespace demold

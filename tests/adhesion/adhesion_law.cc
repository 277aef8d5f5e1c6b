// SPDX-License-Identifier: LGPL-2.1-or-later
// A bond follows its closed forms through all states and mixed modes.
#include "adhesion/adhesion_law.h"

#include "bonds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  const LinearSoftening reference{0.2, 0.1, 20.};

  // Theory C.2: alpha = 0.2, delta = 0.1, gamma = 20.
  TEST(adhesion_law, follows_the_reference_sequence)
  {
    struct Row
    {
      double         opening, traction, kappa, decohesion_gap, dissipated;
      AdhesionStatus status;
    };
    using S           = AdhesionStatus;
    const Row  rows[] = {{.005, .1, .01, 0., 0., S::adhering},
                         {.01, .2, .01, 0., 0., S::adhering},
                         {.03, .155556, .03, .022222, .002222, S::decohesion},
                         {.055, .1, .055, .05, .005, S::decohesion},
                         {.02, .036364, .055, .05, .005, S::unloading},
                         {0., 0., .055, .05, .005, S::unloading},
                         {.055, .1, .055, .05, .005, S::unloading},
                         {.08, .044444, .08, .077778, .007778, S::decohesion},
                         {.1, 0., .1, .1, .01, S::separated},
                         {.05, 0., .1, .1, .01, S::separated}};
    const auto law    = make_bond(reference);

    AdhesionState state;
    double        kappa = 0.01; // closed form, running along
    for (const Row &row : rows)
      {
        const auto r          = law.evaluate(row.opening * up, up, state);
        state                 = r.state;
        const double traction = r.traction * up;
        EXPECT_EQ(r.status, row.status) << row.opening;
        EXPECT_NEAR(traction, row.traction, 1e-6);
        EXPECT_NEAR(std::max(state.kappa, law.onset_gap()), row.kappa, 1e-6);
        EXPECT_NEAR(state.dissipated, row.dissipated, 1e-6);

        kappa              = std::min(std::max(kappa, row.opening), 0.1);
        const double limit = 0.2 * (0.1 - kappa) / 0.09;
        const double g_d   = kappa - limit / 20.;
        EXPECT_NEAR(g_d, row.decohesion_gap, 1e-6);
        EXPECT_NEAR(traction, limit * std::min(row.opening / kappa, 1.), 1e-12);
        EXPECT_NEAR(state.dissipated, 0.5 * 0.2 * g_d, 1e-12);
        EXPECT_NEAR(r.stored, 0.5 * traction * row.opening, 1e-12);
      }
  }

  // Theory C.2: peak a/b alpha, rupture delta/b, G_II = a/b^2 G_I.
  TEST(adhesion_law, shear_has_the_peak_and_gap_of_its_mixing)
  {
    const double peak[]   = {1., coupling, coupling, coupling};
    const double length[] = {1., 1., 1. / coupling, coupling};
    const double energy[] = {1., coupling, 1., coupling * coupling};
    for (unsigned int i = 0; i < 4; ++i)
      {
        const auto    law = make_bond(reference, all_mixings[i]);
        AdhesionState state;
        double        largest = 0., work = 0., before = 0.;
        const int     n      = 10000; // the peak g_0/b lies on a sample
        const double  slip   = length[i] * reference.gap / n;
        bool          bonded = true;
        for (int step = 1; step <= n; ++step)
          {
            const auto r =
              law.evaluate(step * slip * vector(.6, .8, 0.), up, state);
            state   = r.state;
            largest = std::max(largest, r.traction.norm());
            work += 0.5 * slip * (before + r.traction.norm());
            before = r.traction.norm();
            bonded = r.status != AdhesionStatus::separated;
            EXPECT_EQ(bonded, step < n);
          }
        EXPECT_NEAR(largest, peak[i] * 0.2, 1e-12);
        EXPECT_NEAR(work, energy[i] * 0.01, 1e-12);
        EXPECT_NEAR(state.dissipated, energy[i] * 0.01, 1e-14);
        EXPECT_NEAR(law.fracture_energy(std::acos(0.)),
                    energy[i] * 0.01,
                    1e-15);
      }
  }

  TEST(adhesion_law, unloads_to_the_origin_along_the_secant)
  {
    for (const AdhesionLaw &law : all_bonds())
      if (law.unloading == AdhesionUnloading::damage)
        {
          const Vector3 far    = vector(.01, .02, .03);
          const auto    loaded = law.evaluate(far, up, {});
          ASSERT_EQ(loaded.status, AdhesionStatus::decohesion);
          for (const double part : {0.9, 0.5, 1e-3, 0.})
            {
              const auto r = law.evaluate(part * far, up, loaded.state);
              EXPECT_EQ(r.status, AdhesionStatus::unloading);
              EXPECT_LT((r.traction - part * loaded.traction).norm(), 1e-15);
              EXPECT_EQ(r.dissipated_increment, 0.);
            }
        }
  }

  TEST(adhesion_law, pressure_alone_neither_damages_nor_pulls)
  {
    for (const AdhesionLaw &law : all_bonds())
      {
        const auto pressed = law.evaluate(-1. * up, up, {});
        EXPECT_EQ(pressed.status, AdhesionStatus::adhering);
        EXPECT_EQ(pressed.state.kappa, 0.);
        EXPECT_EQ(pressed.traction.norm(), 0.);
        // Nor does it heal, nor hinder shear from damaging.
        const auto sheared =
          law.evaluate(vector(.02 / law.factors.b, 0., -1.), up, {});
        EXPECT_EQ(sheared.status, AdhesionStatus::decohesion);
        EXPECT_NEAR(sheared.state.kappa, 0.02, 1e-15);
        const auto again = law.evaluate(-1. * up, up, sheared.state);
        EXPECT_EQ(again.state.kappa, sheared.state.kappa);
      }
  }

  // A slave node starts at g = 0: nothing else may hold it there.
  TEST(adhesion_law, fresh_bond_is_stiff_in_every_direction)
  {
    const auto r = make_bond(reference).evaluate(Vector3(), up, {});
    EXPECT_DOUBLE_EQ(r.dt_dg[2][2], 20.);
    EXPECT_DOUBLE_EQ(r.dt_dg[0][0], coupling * coupling * 20.);
  }

  TEST(adhesion_law, strength_factor_scales_forces_and_energies)
  {
    for (const AdhesionLaw &law : all_bonds())
      {
        AdhesionState weak;
        weak.strength_factor = 0.3;
        const Vector3 gap    = vector(.01, -.02, .02);
        const auto    full   = law.evaluate(gap, up, {});
        const auto    part   = law.evaluate(gap, up, weak);
        EXPECT_LT((part.traction - 0.3 * full.traction).norm(), 1e-15);
        EXPECT_NEAR(part.stored, 0.3 * full.stored, 1e-16);
        EXPECT_NEAR(part.dissipated_increment,
                    0.3 * full.dissipated_increment,
                    1e-16);
        EXPECT_EQ(part.state.kappa, full.state.kappa);
        EXPECT_GT(full.dissipated_increment, 0.);
      }
  }

  TEST(adhesion_law, forced_branch_is_taken_and_marked)
  {
    using S        = AdhesionStatus;
    const auto law = make_bond(reference);
    // Held adhering beyond the onset: still slope gamma, not acceptable.
    auto r = law.evaluate(.03 * up, up, {}, S::adhering);
    EXPECT_DOUBLE_EQ(r.traction * up, 20. * .03);
    EXPECT_FALSE(r.consistent);
    // No skip from adhering to separated: the branch goes on, unclipped.
    r = law.evaluate(.12 * up, up, {}, S::decohesion);
    EXPECT_NEAR(r.traction * up, 0.2 * (.1 - .12) / .09, 1e-15);
    EXPECT_EQ(r.state.kappa, law.rupture_gap());
    EXPECT_FALSE(r.consistent);
    // Just below the onset: the elastic force, the slopes of loading.
    r = law.evaluate(.00999 * up, up, {}, S::decohesion);
    EXPECT_NEAR(r.traction * up, 20. * .00999, 1e-15);
    EXPECT_LT(r.dt_dg[2][2], 0.);
    EXPECT_LT(r.path_increment, 0.);
    EXPECT_NEAR(r.path_gradient * up, 0.5 * .2 * .1 / .09, 1e-14);
    // Below the present damage: the branch as it was, no healing.
    const auto damaged = law.evaluate(.05 * up, up, {});
    r = law.evaluate(.0499 * up, up, damaged.state, S::decohesion);
    EXPECT_NEAR(r.traction * up, 0.2 * (.1 - .0499) / .09, 1e-14);
    EXPECT_EQ(r.state.kappa, .05);
    EXPECT_NEAR(r.path_increment, -.0001 * .5 * .2 * .1 / .09, 1e-15);
    EXPECT_FALSE(r.consistent);
    // Forced to what the gap asks for anyway.
    r = law.evaluate(.03 * up, up, {}, S::decohesion);
    EXPECT_TRUE(r.consistent);
    // Gone is gone.
    const auto gone = law.evaluate(.2 * up, up, {});
    r               = law.evaluate(.03 * up, up, gone.state, S::decohesion);
    EXPECT_EQ(r.status, S::separated);
    EXPECT_EQ(r.traction.norm(), 0.);
  }

  TEST(adhesion_law, utilisation_is_one_where_damage_starts)
  {
    const auto law = make_bond(reference);
    EXPECT_DOUBLE_EQ(law.evaluate(.005 * up, up, {}).utilisation, 0.5);
    const auto loaded = law.evaluate(.04 * up, up, {});
    EXPECT_DOUBLE_EQ(loaded.utilisation, 4.);
    EXPECT_DOUBLE_EQ(law.evaluate(.04 * up, up, loaded.state).utilisation, 1.);
    const auto dragged =
      make_bond(reference, ModeMixing::energy, AdhesionUnloading::plastic);
    const auto    r    = dragged.evaluate(.04 * up, up, {});
    const Vector3 rest = .04 * up - r.anchor_shift;
    EXPECT_NEAR(dragged.evaluate(rest, up, r.state).utilisation, 1., 1e-12);
  }

  // Theory C.2, "plastic": slope gamma, x_a <- x_s - t_a/gamma.
  TEST(adhesion_law, plastic_sliding_drags_the_anchor)
  {
    for (const ModeMixing mixing : all_mixings)
      {
        const auto law =
          make_bond(reference, mixing, AdhesionUnloading::plastic);
        const auto [a, b] = law.factors;
        AdhesionState state;
        double        anchor = 0.;
        // Effective slips there and back under pressure; the gap relaxes.
        const double total = .04 / b;
        const auto   r =
          law.evaluate(vector(total - anchor, 0., -.001), up, state);
        const double limit = 0.2 * (.1 - .04) / .09;
        EXPECT_NEAR(r.traction[0], a / b * limit, 1e-15);
        anchor += r.anchor_shift[0];
        EXPECT_NEAR(anchor, total - r.traction[0] / (a * 20.), 1e-15);
        EXPECT_NEAR(b * anchor, .04 - limit / 20., 1e-15); // g_d
        EXPECT_EQ(r.anchor_shift[2], 0.);
        state = r.state;

        // Slope gamma back through zero force at the new anchor.
        const auto back =
          law.evaluate(vector(.9 * anchor - anchor, 0., -.001), up, state);
        EXPECT_NEAR(back.traction[0], -a * 20. * .1 * anchor, 1e-15);
        EXPECT_EQ(back.status, AdhesionStatus::unloading);
        EXPECT_EQ(back.anchor_shift.norm(), 0.);

        // Sliding on is as if it had never stopped.
        const auto on =
          law.evaluate(vector(.07 / b - anchor, 0., -.001), up, state);
        EXPECT_NEAR(on.traction[0], a / b * .2 * (.1 - .07) / .09, 1e-15);
        EXPECT_NEAR(on.state.kappa, .07, 1e-15);
      }
  }

  TEST(adhesion_law, friction_weight_follows_the_damage)
  {
    auto law = make_bond(reference);
    EXPECT_EQ(law.friction_weight(.02), 1.);
    law.friction = FrictionWeight::after_rupture;
    EXPECT_EQ(law.friction_weight(.0999), 0.);
    EXPECT_EQ(law.friction_weight(.1), 1.);
    law.friction     = FrictionWeight::damaged_fraction;
    const double g_d = .03 - .2 * (.1 - .03) / .09 / 20.;
    EXPECT_EQ(law.friction_weight(0.), 0.);
    EXPECT_NEAR(law.friction_weight(.03), g_d / .1, 1e-14);
    EXPECT_EQ(law.friction_weight(.1), 1.);
    EXPECT_NEAR(law.friction_weight_derivative(.03), 1. / .09, 1e-12);
  }

  // Theory C.5.
  TEST(adhesion_law, pressed_long_enough_it_sticks_again_but_weaker)
  {
    auto       law    = make_bond(reference);
    const auto gone   = law.evaluate(.2 * up, up, {}).state;
    law.rest_pressure = .1;
    law.rest_time     = 1.;
    EXPECT_EQ(law.rested(gone, .5, 10.).kappa, gone.kappa); // off
    law.rest_efficiency = .25;

    auto state = law.rested(gone, .2, .75);
    EXPECT_EQ(state.kappa, gone.kappa);
    state = law.rested(state, .05, .75); // let go: the clock starts again
    state = law.rested(state, .2, .75);
    EXPECT_EQ(state.kappa, gone.kappa);
    state = law.rested(state, .2, .25);
    EXPECT_EQ(state.kappa, 0.);
    EXPECT_EQ(state.dissipated, gone.dissipated);
    const auto r = law.evaluate(.01 * up, up, state);
    EXPECT_NEAR(r.traction * up, .25 * .2, 1e-15);
    // A bond that still holds does not rest.
    const auto damaged = law.evaluate(.05 * up, up, {}).state;
    EXPECT_EQ(law.rested(damaged, .5, 10.).kappa, damaged.kappa);
  }
} // namespace demold

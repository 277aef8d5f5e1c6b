// SPDX-License-Identifier: LGPL-2.1-or-later
// Work on a bond is stored or lost, never gained, and adds up.
#include "adhesion/adhesion_law.h"
#include "adhesion/gap_path.h"

#include "bonds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demold
{
  using namespace dealii;

  struct Sum
  {
    double           work = 0., lost = 0.;
    AdhesionResponse last;
  };

  // Follows a straight path in n accepted increments, trapezoidal work. The
  // anchor of a plastic bond moves; gaps are given from its first place.
  Sum follow(const AdhesionLaw &law,
             const Vector3     &from,
             const Vector3     &to,
             AdhesionState      state,
             const unsigned int n)
  {
    Sum     sum;
    Vector3 anchor   = from - state.gap;
    auto    traction = law.evaluate(state.gap, up, state).traction;
    for (unsigned int i = 1; i <= n; ++i)
      {
        const Vector3 place = from + (i / double(n)) * (to - from);
        sum.last            = law.evaluate(place - anchor, up, state);
        sum.work +=
          0.5 * (traction + sum.last.traction) * (to - from) / double(n);
        sum.lost += sum.last.dissipated_increment;
        traction = sum.last.traction;
        state    = sum.last.state;
        anchor += sum.last.anchor_shift;
      }
    return sum;
  }

  // Theory C.2, closed form of the mode angle; here for every penalty.
  TEST(adhesion_energies, work_of_separation_follows_the_mode_angle)
  {
    for (const ModeMixing mixing : all_mixings)
      for (const double penalty : {20., 2e4})
        for (const double angle : {0., .3, .8, 1.2, std::acos(0.)})
          {
            const auto law =
              make_bond(LinearSoftening{.2, .1, penalty}, mixing);
            const auto [a, b]    = law.factors;
            const double  c      = std::pow(std::cos(angle), 2);
            const double  s      = std::pow(std::sin(angle), 2);
            const double  W      = .01 * (c + a * s) / (c + b * b * s);
            const double  length = .1 / std::sqrt(c + b * b * s);
            const Vector3 end =
              length * vector(std::sin(angle), 0., std::cos(angle));
            EXPECT_NEAR(law.fracture_energy(angle), W, 1e-15);
            // In one step, and in many.
            const auto once = law.evaluate(1.5 * end, up, {});
            EXPECT_NEAR(once.state.dissipated, W, 1e-14);
            const Sum many = follow(law, Vector3(), end, {}, 20000);
            EXPECT_NEAR(many.lost, W, 1e-13);
            EXPECT_NEAR(many.work, W, 1e-5 * W);
          }
  }

  // Along any straight path, in one increment: integral of t.dg = change of
  // stored + lost, exactly, whatever the mixing and the history.
  TEST(adhesion_energies, one_large_increment_loses_what_many_small_ones_lose)
  {
    std::mt19937                           engine(5);
    std::uniform_real_distribution<double> unit(0., 1.);
    for (const AdhesionLaw &law : all_bonds())
      if (law.unloading == AdhesionUnloading::damage)
        for (unsigned int i = 0; i < 8; ++i)
          {
            const Vector3 from  = .05 * unit(engine) * random_direction(engine);
            const Vector3 to    = .15 * unit(engine) * random_direction(engine);
            const auto    start = law.evaluate(from, up, {});
            const Sum     once  = follow(law, from, to, start.state, 1);
            const Sum     many  = follow(law, from, to, start.state, 4000);
            EXPECT_NEAR(once.lost, many.lost, 2e-9);
            EXPECT_NEAR(many.work,
                        once.last.stored - start.stored + once.lost,
                        2e-7);
          }
  }

  // Plastic: exact for straight sliding, also there and back.
  TEST(adhesion_energies, plastic_sliding_loses_the_area_under_its_loop)
  {
    const double first = .06, second = .02;
    for (const ModeMixing mixing : all_mixings)
      {
        const auto law    = make_bond(LinearSoftening{.2, .1, 20.},
                                   mixing,
                                   AdhesionUnloading::plastic);
        const auto [a, b] = law.factors;
        const auto limit  = [](const double kappa) {
          return .2 * (.1 - kappa) / .09;
        };
        const auto g_d = [&](const double kappa) {
          return kappa - limit(kappa) / 20.;
        };
        const auto closed_form = [&](const double kappa) {
          return a / (b * b) * .2 * g_d(kappa) * (1. - g_d(kappa) / .2);
        };
        const Vector3 there = vector(first / b, 0., -.001);
        const Sum     out   = follow(law, Vector3(), there, {}, 1);
        EXPECT_NEAR(out.lost, closed_form(first), 1e-15);
        EXPECT_NEAR(out.last.stored,
                    a / (b * b) * limit(first) * limit(first) / 40.,
                    1e-15);
        // Back, until it slides the other way: the limit goes on falling.
        const Vector3 back = vector(second / b, 0., -.001);
        const Sum     home = follow(law, there, back, out.last.state, 1);
        // The first 2 s/gamma on the way back are elastic.
        const double kappa_back =
          first + (first - second) - 2. * limit(first) / 20.;
        EXPECT_NEAR(home.last.state.kappa, kappa_back, 1e-15);
        EXPECT_NEAR(out.lost + home.lost, closed_form(kappa_back), 1e-15);
        const Sum many = follow(law, there, back, out.last.state, 20000);
        EXPECT_NEAR(many.lost, home.lost, 1e-12);
        EXPECT_NEAR(many.work,
                    home.last.stored - out.last.stored + home.lost,
                    1e-7);
      }
  }

  TEST(adhesion_energies, random_paths_never_gain_energy_or_lose_damage)
  {
    std::mt19937                           engine(11);
    std::uniform_real_distribution<double> unit(0., 1.);
    for (const AdhesionLaw &law : all_bonds())
      for (unsigned int path = 0; path < 20; ++path)
        {
          AdhesionState state;
          Vector3       place, anchor;
          double        kappa = 0.;
          for (unsigned int i = 0; i < 100; ++i)
            {
              place += .01 * unit(engine) * random_direction(engine);
              const auto r = law.evaluate(place - anchor, up, state);
              EXPECT_GE(r.dissipated_increment, 0.);
              EXPECT_GE(r.stored, 0.);
              EXPECT_GE(r.state.kappa, kappa);
              EXPECT_TRUE(r.consistent);
              EXPECT_LE(r.state.dissipated,
                        std::max(1.,
                                 law.fracture_energy(std::acos(0.)) /
                                   law.fracture_energy()) *
                          law.fracture_energy() * (1. + 1e-12));
              kappa = r.state.kappa;
              state = r.state;
              anchor += r.anchor_shift;
            }
        }
  }

  TEST(adhesion_energies, rupture_leaves_nothing_stored_and_all_lost)
  {
    for (const AdhesionLaw &law : all_bonds())
      {
        AdhesionState state;
        Vector3       anchor;
        for (const double part : {.003, .1, .3, .31, .9, 1.01})
          {
            const Vector3 place = part * law.rupture_gap() * up;
            const auto    r     = law.evaluate(place - anchor, up, state);
            state               = r.state;
            anchor += r.anchor_shift;
            if (part > 1.)
              {
                EXPECT_EQ(r.status, AdhesionStatus::separated);
                EXPECT_EQ(r.stored, 0.);
              }
          }
        EXPECT_NEAR(state.dissipated / law.fracture_energy(), 1., 1e-13);
      }
  }

  TEST(gap_path, finds_where_the_effective_gap_is_reached)
  {
    const GapPath path{vector(.03, 0., -.01),
                       vector(-.05, .02, .08),
                       up,
                       mode_factors(ModeMixing::slip_limit, .5)};
    for (const double kappa : {.04, .06, .08})
      {
        const double fraction = path.reaches(kappa);
        EXPECT_NEAR(std::sqrt(path.effective_squared(fraction)), kappa, 1e-15);
        EXPECT_GT(path.effective_squared_rate(fraction), 0.);
        const double h = 1e-6;
        EXPECT_NEAR((path.effective_squared(fraction + h) -
                     path.effective_squared(fraction - h)) /
                      (2. * h),
                    path.effective_squared_rate(fraction),
                    1e-9);
      }
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Damage that takes time: a bond pulled at constant rate follows the ordinary
// differential equation, its extra work vanishes with the viscous time, and
// without viscous time nothing changes.
#include "adhesion/viscous_damage.h"

#include "bonds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr double speed = 1.; // [mm/s]

    AdhesionLaw slow_bond(const Softening &softening,
                          const double     viscous_time,
                          const ModeMixing mixing = ModeMixing::energy)
    {
      AdhesionLaw law  = make_bond(softening, mixing);
      law.viscous_time = viscous_time;
      return law;
    }

    double length_of(const Softening &softening)
    {
      return std::visit([](const auto &s) { return s.gap; }, softening);
    }

    // kappa' = (delta/tau) (v t/kappa - 1) from onset on, by the classical
    // Runge-Kutta rule; and what it does per area until rupture.
    struct Reference
    {
      double peak = 0., work = 0., lost = 0., taken = 0., end_gap = 0.;
    };

    Reference integrate(const LinearSoftening &s,
                        const double           tau,
                        const unsigned int     n)
    {
      const double onset = s.onset_gap();
      const auto   rate  = [&](const double gap, const double kappa) {
        return s.gap / tau * (gap / kappa - 1.);
      };
      const double dt    = s.gap / speed / n;
      double       gap   = onset;
      double       kappa = onset;
      Reference    r;
      r.peak = s.strength;
      r.work = .5 * s.strength * onset;
      while (true)
        {
          const double dg   = speed * dt;
          const double k1   = rate(gap, kappa);
          const double k2   = rate(gap + .5 * dg, kappa + .5 * dt * k1);
          const double k3   = rate(gap + .5 * dg, kappa + .5 * dt * k2);
          const double k4   = rate(gap + dg, kappa + dt * k3);
          double       next = kappa + dt / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
          const double part =
            next > s.gap ? (s.gap - kappa) / (next - kappa) : 1.;
          next                = std::min(next, s.gap);
          const auto traction = [&](const double g, const double k) {
            return s.on_curve(k).limit * g / k;
          };
          const double before = traction(gap, kappa);
          // D = G_c g_d/delta; overstress x = gap/kappa - 1, loss (1 + x)^2 dD
          const double dD = .5 * s.steepest_slope() * s.gap * (next - kappa);
          const double x  = .5 * (gap / kappa + (gap + part * dg) / next);
          gap += part * dg;
          kappa            = next;
          const double now = traction(gap, kappa);
          r.peak           = std::max(r.peak, now);
          r.work += .5 * (before + now) * part * dg;
          r.lost += dD;
          r.taken += (x * x - 1.) * dD;
          r.end_gap = gap;
          if (kappa >= s.gap)
            return r;
        }
    }

    struct Pulled
    {
      double peak = 0., work = 0., lost = 0., taken = 0., end_gap = 0.;
    };

    // The law in increments of equal time, straight at @p angle to the normal.
    Pulled pull(const AdhesionLaw &law,
                const double       dt,
                const double       angle = 0.)
    {
      const Vector3 way =
        std::cos(angle) * up + std::sin(angle) * vector(1., 0., 0.);
      const AdhesionLaw over = law.over(dt);
      AdhesionState     state;
      Pulled            p;
      double            before = 0.;
      for (unsigned int i = 1; i < 10000000; ++i)
        {
          const double gap = i * dt * speed;
          const auto   r   = over.evaluate(gap * way, up, state);
          state            = r.state;
          const double t   = r.traction * way;
          p.peak           = std::max(p.peak, t);
          p.work += .5 * (before + t) * dt * speed;
          p.lost += r.dissipated_increment;
          p.taken += r.regularisation_increment;
          p.end_gap = gap;
          before    = t;
          if (r.status == AdhesionStatus::separated)
            return p;
        }
      return p;
    }
  } // namespace



  TEST(viscous_damage, solves_its_equation_and_has_its_slope)
  {
    for (const double start : {0., .01, .05})
      for (const double reach : {1e-9, 1e-3, .1, 1e3, 1e12})
        for (const double gap : {start + .001, .06, 1.})
          {
            const auto   d     = viscous_damage(start, gap, reach);
            const double left  = d.kappa * (d.kappa - start);
            const double right = reach * (gap - d.kappa);
            // The difference of gap and kappa keeps that many digits less.
            EXPECT_NEAR(left, right, 1e-14 * (1. + reach) * gap);
            EXPECT_GE(d.kappa, start);
            EXPECT_LE(d.kappa, gap * (1. + 1e-15));
            const double h = 1e-6 * (gap + .01);
            EXPECT_NEAR((viscous_damage(start, gap + h, reach).kappa -
                         viscous_damage(start, gap, reach).kappa) /
                          h,
                        viscous_damage(start, gap + .5 * h, reach).rate,
                        1e-4);
          }
  }

  TEST(viscous_damage, stands_still_in_no_time_and_is_the_gap_in_all_time)
  {
    EXPECT_EQ(viscous_damage(.03, .07, 0.).kappa, .03);
    EXPECT_EQ(viscous_damage(.03, .07, 0.).rate, 0.);
    EXPECT_NEAR(viscous_damage(.03, .07, 1e12).kappa, .07, 1e-13);
    EXPECT_NEAR(viscous_damage(.03, .07, 1e12).rate, 1., 1e-12);
    EXPECT_EQ(viscous_damage(0., 0., 0.).kappa, 0.);
  }

  // The claim of the header: limit times 1 + tau kappa'/delta.
  TEST(viscous_bond, carries_its_limit_and_the_force_of_a_dashpot)
  {
    const double tau = .03, dt = .004;
    for (const Softening &softening :
         {Softening(LinearSoftening{.2, .1, 20.}),
          Softening(ExponentialSoftening{.2, .05, 20.})})
      {
        const AdhesionLaw law = slow_bond(softening, tau).over(dt);
        AdhesionState     old;
        old.kappa          = .03;
        const auto   r     = law.evaluate(.05 * up, up, old);
        const double speed = (r.state.kappa - old.kappa) / dt;
        const double limit = std::visit(
          [&](const auto &s) { return s.on_curve(r.state.kappa).limit; },
          softening);
        EXPECT_NEAR(r.traction * up,
                    limit * (1. + tau * speed / length_of(softening)),
                    1e-14);
        EXPECT_GT(r.state.kappa, old.kappa);
        EXPECT_LT(r.state.kappa, .05);
      }
  }

  TEST(viscous_bond, pulled_at_constant_rate_follows_the_differential_equation)
  {
    for (const double penalty : {20., 200.})
      for (const double tau : {.001, .01, .05})
        {
          const LinearSoftening s{.2, .1, penalty};
          const Reference       exact = integrate(s, tau, 400000);
          const AdhesionLaw     law   = slow_bond(s, tau);
          // First order in the increment: a tenth of it, a tenth of the error.
          const Pulled coarse = pull(law, 2e-5);
          const Pulled fine   = pull(law, 2e-6);
          const double G_c    = s.fracture_energy();
          EXPECT_NEAR(fine.peak, exact.peak, 2e-3 * exact.peak);
          EXPECT_NEAR(fine.work, exact.work, 1e-3 * G_c);
          EXPECT_NEAR(fine.taken, exact.taken, 1e-3 * G_c);
          EXPECT_NEAR(fine.end_gap, exact.end_gap, 1e-3 * s.gap);
          EXPECT_NEAR(fine.lost, G_c, 1e-12);
          EXPECT_NEAR(std::abs(coarse.taken - exact.taken) /
                        std::abs(fine.taken - exact.taken),
                      10.,
                      2.);
        }
  }

  // For a bond rigid up to its strength kappa' is the speed: peak alpha (1 + x)
  // and 2 x + x^2 of G_c beyond G_c, x = tau speed/delta, but for what happens
  // over the lag x delta at the end.
  TEST(viscous_bond, takes_work_in_proportion_to_the_viscous_time)
  {
    const LinearSoftening s{.2, .1, 20000.};
    double                last = 0.;
    for (const double tau : {1e-4, 3e-4, 1e-3, 3e-3})
      {
        const double x     = tau * speed / s.gap;
        const Pulled p     = pull(slow_bond(s, tau), 1e-6);
        const double share = p.taken / s.fracture_energy();
        EXPECT_NEAR(share, 2. * x, .03 * 2. * x);
        EXPECT_NEAR(p.peak, s.strength * (1. + x), .1 * x * s.strength);
        EXPECT_GT(share, last);
        last = share;
      }
  }

  TEST(viscous_bond, work_is_stored_lost_or_taken)
  {
    for (const Softening &softening :
         {Softening(LinearSoftening{.2, .1, 20.}),
          Softening(ExponentialSoftening{.2, .05, 20.})})
      for (const ModeMixing mixing : all_mixings)
        for (const double angle : {0., .8, 1.5})
          {
            const Pulled p =
              pull(slow_bond(softening, .01, mixing), 2e-5, angle);
            EXPECT_NEAR(p.work, p.lost + p.taken, 5e-4 * p.work);
            EXPECT_GT(p.taken, 0.);
          }
  }

  TEST(viscous_bond, never_gains_energy_on_random_paths)
  {
    std::mt19937                           engine(17);
    std::uniform_real_distribution<double> unit(0., 1.);
    for (const Softening &softening :
         {Softening(LinearSoftening{.2, .1, 20.}),
          Softening(ExponentialSoftening{.2, .05, 20.})})
      for (unsigned int path = 0; path < 50; ++path)
        {
          const AdhesionLaw law = slow_bond(softening, .02);
          AdhesionState     state;
          Vector3           gap;
          for (unsigned int i = 0; i < 100; ++i)
            {
              gap += .01 * unit(engine) * random_direction(engine);
              const auto r =
                law.over(.02 * unit(engine)).evaluate(gap, up, state);
              EXPECT_GE(r.dissipated_increment, 0.);
              EXPECT_GE(r.regularisation_increment, 0.);
              EXPECT_GE(r.state.kappa, state.kappa);
              EXPECT_TRUE(r.consistent);
              state = r.state;
            }
        }
  }

  TEST(viscous_bond, tangent_matches_differences)
  {
    std::mt19937                           engine(23);
    std::uniform_real_distribution<double> unit(0., 1.);
    unsigned int                           softens = 0;
    for (const Softening &softening :
         {Softening(LinearSoftening{.2, .1, 20.}),
          Softening(ExponentialSoftening{.2, .05, 20.})})
      for (const ModeMixing mixing : all_mixings)
        for (unsigned int i = 0; i < 200; ++i)
          {
            const AdhesionLaw law =
              slow_bond(softening, .02, mixing).over(.02 * unit(engine) + 1e-4);
            const Vector3 n = random_direction(engine);
            AdhesionState old;
            old.kappa         = .08 * unit(engine);
            const Vector3 gap = .1 * unit(engine) * n +
                                .1 * unit(engine) * random_tangent(n, engine);
            const auto   r = law.evaluate(gap, n, old);
            const double h = 1e-7;
            Tensor<2, 3> by_gap;
            Vector3      path, kappa;
            bool         one_branch = true;
            for (unsigned int d = 0; d < 3; ++d)
              {
                Vector3 step;
                step[d]         = h;
                const auto plus = law.evaluate(gap + step, n, old);
                const auto less = law.evaluate(gap - step, n, old);
                one_branch      = one_branch && plus.status == r.status &&
                             less.status == r.status;
                for (unsigned int e = 0; e < 3; ++e)
                  by_gap[e][d] =
                    (plus.traction[e] - less.traction[e]) / (2. * h);
                path[d] =
                  (plus.path_increment - less.path_increment) / (2. * h);
                kappa[d] = (plus.state.kappa - less.state.kappa) / (2. * h);
              }
            if (!one_branch || r.status != AdhesionStatus::decohesion)
              continue;
            ++softens;
            EXPECT_LT((r.dt_dg - by_gap).norm(), 1e-5 * r.dt_dg.norm() + 1e-6);
            EXPECT_LT((r.path_gradient - path).norm(), 1e-6);
            EXPECT_LT((r.dkappa_dg - kappa).norm(), 1e-6);
            if (law.symmetric())
              {
                EXPECT_LT((r.dt_dg - transpose(r.dt_dg)).norm(),
                          1e-13 * r.dt_dg.norm());
              }
          }
    EXPECT_GT(softens, 300u);
  }

  // What stabilises: in a short increment a softening bond is stiff.
  TEST(viscous_bond, stiffens_in_short_increments)
  {
    const LinearSoftening s{.2, .1, 20.};
    AdhesionState         old;
    old.kappa        = .05;
    const auto slope = [&](const double dt) {
      return slow_bond(s, .01)
        .over(dt)
        .evaluate(.051 * up, up, old)
        .dt_dg[2][2];
    };
    EXPECT_NEAR(
      slow_bond(s, 0.).over(1.).evaluate(.051 * up, up, old).dt_dg[2][2],
      -s.steepest_slope(),
      1e-12);
    EXPECT_NEAR(slope(1e6), -s.steepest_slope(), 1e-6);
    EXPECT_GT(slope(1e-4), 0.);
    EXPECT_NEAR(slope(0.), s.secant(.05), 1e-12);
  }

  // Off: over() leaves the law, and the response bitwise.
  TEST(viscous_bond, without_viscous_time_is_bitwise_the_bond)
  {
    std::mt19937                           engine(29);
    std::uniform_real_distribution<double> unit(0., 1.);
    for (const AdhesionLaw &law : all_bonds())
      for (unsigned int i = 0; i < 50; ++i)
        {
          AdhesionState old;
          old.kappa         = .08 * unit(engine);
          const Vector3 gap = .12 * unit(engine) * random_direction(engine);
          const auto    a   = law.evaluate(gap, up, old);
          const auto    b   = law.over(unit(engine)).evaluate(gap, up, old);
          EXPECT_TRUE(a.traction == b.traction);
          EXPECT_TRUE(a.dt_dg == b.dt_dg);
          EXPECT_EQ(a.state.kappa, b.state.kappa);
          EXPECT_EQ(a.dissipated_increment, b.dissipated_increment);
          EXPECT_EQ(b.regularisation_increment, 0.);
        }
  }
} // namespace demold

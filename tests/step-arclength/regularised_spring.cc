// SPDX-License-Identifier: LGPL-2.1-or-later
// spring-regularised.prm: where the path turns back, quasi-statics goes on
// through viscous damage, which takes what a jump would release.
#include "step-arclength/path_points.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    /// The spring and bond of theory E.1a with kappa' = (delta/tau)(g/kappa -
    /// 1) beyond the onset, the grip pulled with 1 mm/s: classical Runge-Kutta.
    struct SlowBond
    {
      SpringAndBond form;
      double        tau; ///< [s]

      /// Gap at opening @p u: k_s (u - g) = s(kappa) g/kappa.
      double gap(const double u, const double kappa) const
      {
        return u * form.k / (form.k + limit(kappa) / kappa);
      }

      double limit(const double kappa) const
      {
        return form.bond.strength * (form.bond.rupture - kappa) /
               (form.bond.rupture - form.bond.onset());
      }

      double rate(const double u, const double kappa) const
      {
        return form.bond.rupture / tau *
               std::max(0., gap(u, kappa) / kappa - 1.);
      }

      struct Result
      {
        double peak = 0., work = 0.,
               opening = 0.; ///< [N], [mJ], [mm] at rupture
      };

      Result integrate() const
      {
        double u     = form.peak_opening();
        double kappa = form.bond.onset();
        Result result{form.bond.strength, .5 * u * form.bond.strength, u};
        double before = form.bond.strength;
        while (kappa < form.bond.rupture)
          {
            const double h  = 1e-3 * tau;
            const double k1 = rate(u, kappa);
            const double k2 = rate(u + .5 * h, kappa + .5 * h * k1);
            const double k3 = rate(u + .5 * h, kappa + .5 * h * k2);
            const double k4 = rate(u + h, kappa + h * k3);
            kappa += h / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
            u += h;
            const double now = form.k * (u - gap(u, kappa));
            result.peak      = std::max(result.peak, now);
            result.work += .5 * (before + now) * h;
            before = now;
          }
        result.opening = u;
        return result;
      }
    };

    SceneRun run_regularised(const double tau)
    {
      return run_arclength("spring-regularised.prm",
                           {"Adhesion/viscous time=" + std::to_string(tau)});
    }
  } // namespace

  TEST(RegularisedSpring, follows_the_differential_equation_without_a_jump)
  {
    const SpringAndBond form{.5, {}};
    for (const double tau : {1e-3, 4e-3})
      {
        const SceneRun         run   = run_regularised(tau);
        const SlowBond::Result exact = SlowBond{form, tau}.integrate();
        EXPECT_EQ(run.status(), "completed");
        EXPECT_EQ(run.number("jumps"), 0.);
        EXPECT_EQ(run.number("released energy [mJ]"), 0.);
        EXPECT_LT(run.number("energy balance error [-]"), 1e-2);
        EXPECT_NEAR(run.number("peak force [N]"), exact.peak, .01 * exact.peak);
        EXPECT_NEAR(run.number("work of demolding [mJ]"),
                    exact.work,
                    .02 * exact.work);
        EXPECT_NEAR(run.number("adhesion dissipation [mJ]"),
                    form.bond.fracture_energy(),
                    1e-6);
        EXPECT_NEAR(run.number("regularisation dissipation [mJ]"),
                    exact.work - form.bond.fracture_energy(),
                    .03 * exact.work);
      }
  }

  // 0.031 mJ, theory E.1a; the rest is the work of the grip during the jump,
  // which lasts as long as the viscous time.
  TEST(RegularisedSpring, takes_what_the_jump_releases_as_the_time_goes_to_0)
  {
    const SpringAndBond form{.5, {}};
    std::vector<double> beyond;
    for (const double tau : {4e-3, 1e-3})
      beyond.push_back(
        run_regularised(tau).number("regularisation dissipation [mJ]") -
        form.released());
    EXPECT_GT(beyond[1], 0.);
    EXPECT_LT(beyond[1], .4 * beyond[0]);
    EXPECT_LT(beyond[1], .1 * form.released());
  }

  TEST(RegularisedSpring, jumps_without_the_viscous_time)
  {
    const SceneRun run = run_regularised(0.);
    EXPECT_NE(run.status(), "completed");
    EXPECT_EQ(run.number("regularisation dissipation [mJ]"), 0.);
  }
} // namespace demold

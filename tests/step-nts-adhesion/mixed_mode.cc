// SPDX-License-Identifier: LGPL-2.1-or-later
// mixed-mode.prm: work of separation over the angle to the normal, of a rigid
// block and of a sheet of rubber.
#include "step-nts-adhesion/run_nts.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double area = 100., fracture_energy = .01;

    struct Mixing
    {
      const char *name;
      double      coupling, a, b; // beta_T; factors of theory C.2
    };

    void PrintTo(const Mixing &mixing, std::ostream *out)
    {
      *out << mixing.name;
    }

    /// The scene pulled at an angle to the normal, cosine c, sine s.
    SceneRun run_mixed(const Mixing            &mixing,
                       const double             c,
                       const double             s,
                       std::vector<std::string> overrides = {})
    {
      const auto text = [](const char *format, double x, double y = 0.) {
        char line[80];
        std::snprintf(line, sizeof(line), format, x, y);
        return std::string(line);
      };
      for (const auto &entry :
           {text("Supports/motion x=0.3*t*%.17g", s),
            text("Supports/motion y=0.3*t*%.17g", c),
            text("Process/direction=%.17g,%.17g,0", s, c),
            std::string("Adhesion/mixing=") + mixing.name,
            text("Adhesion/tangential coupling=%.17g", mixing.coupling)})
        overrides.push_back(entry);
      return run_nts("mixed-mode.prm", overrides);
    }

    double cosine(const int degree)
    {
      return degree == 90 ? 0. : std::cos(degree * std::acos(-1.) / 180.);
    }

    double sine(const int degree)
    {
      return std::sin(degree * std::acos(-1.) / 180.);
    }

    /// A wide sheet in series with its bond. Its nominal tractions are those
    /// of F = [1 g; 0 l]: shear (mu1 + mu2) g whatever l, and tension that of a
    /// confined column whatever g (theory A1).
    struct Sheet
    {
      Mixing mixing;
      double height = .1; // [mm]
      Bond   bond{.2, .1, 200.};
      Rubber rubber{};

      struct State
      {
        double g_n, g_t, t_n, t_t; // gaps [mm], tractions [MPa]
      };

      /// With effective gap @p kappa, under a pull along (s, c): the ratio of
      /// the gaps is such that sheet and bond together follow it.
      State at(const double kappa, const double c, const double s) const
      {
        const double k    = bond.traction(kappa) / kappa;
        const auto   with = [&](const double psi) {
          const double g_n = kappa * std::cos(psi);
          const double g_t = kappa * std::sin(psi) / mixing.b;
          return State{g_n, g_t, k * g_n, k * mixing.a * g_t};
        };
        const auto across = [&](const double psi) {
          const State  x = with(psi);
          const double u_n =
            x.g_n + height * (rubber.confined_stretch(x.t_n) - 1.);
          const double u_t = x.g_t + height * x.t_t / (rubber.mu1 + rubber.mu2);
          return u_t * c - u_n * s;
        };
        // A little beyond pure shear, so that it lies inside.
        return with(root_of(across, 0., 1.6));
      }

      /// Work [mJ/mm^2] of the bond along its gap path. The sheet gives all it
      /// has stored back: this is the work of the pull, too.
      double work(const double c, const double s) const
      {
        constexpr unsigned int n   = 400;
        double                 sum = 0.;
        State                  old = at(1e-9, c, s);
        for (unsigned int i = 1; i <= 2 * n; ++i)
          {
            const double kappa =
              i <= n ?
                bond.onset() * i / n :
                bond.onset() + (bond.rupture - bond.onset()) * (i - n) / n;
            const State now = at(kappa, c, s);
            sum += .5 * (now.t_n + old.t_n) * (now.g_n - old.g_n) +
                   .5 * (now.t_t + old.t_t) * (now.g_t - old.g_t);
            old = now;
          }
        return sum;
      }
    };

    class MixedMode : public testing::TestWithParam<Mixing>
    {};

    class ElasticMixedMode : public testing::TestWithParam<Mixing>
    {};

    const auto mixings = testing::Values(Mixing{"isotropic", 1., 1., 1.},
                                         Mixing{"slip limit", .5, .5, 1.},
                                         Mixing{"energy", .5, .25, .5},
                                         Mixing{"proportional", .5, 1., 2.});
  } // namespace

  TEST_P(MixedMode, needs_the_work_of_the_closed_form_at_every_angle)
  {
    const Mixing &mixing = GetParam();
    for (const int degree : {0, 15, 30, 45, 60, 75, 90})
      {
        const double   c = cosine(degree), s = sine(degree);
        const SceneRun run   = run_mixed(mixing, c, s);
        const double   exact = fracture_energy * area *
                             (c * c + mixing.a * s * s) /
                             (c * c + mixing.b * mixing.b * s * s);
        EXPECT_EQ(run.number("bonded area left [mm^2]"), 0.) << degree;
        EXPECT_NEAR(run.number("work of demolding [mJ]"), exact, 1e-3 * exact)
          << degree;
        EXPECT_NEAR(run.number("adhesion dissipation [mJ]"),
                    exact,
                    1e-3 * exact)
          << degree;
      }
  }

  INSTANTIATE_TEST_SUITE_P(mixings, MixedMode, mixings);

  TEST_P(ElasticMixedMode, gives_the_sheets_energy_back_and_needs_that_of_bonds)
  {
    const Mixing &mixing = GetParam();
    const Sheet   sheet{mixing};
    for (const int degree : {30, 60, 90})
      {
        SCOPED_TRACE(degree);
        const double   c = cosine(degree), s = sine(degree);
        const SceneRun run = run_mixed(mixing,
                                       c,
                                       s,
                                       {"Supports/driven=top xy",
                                        "Process/force on=top",
                                        "Body/size=10, 0.1",
                                        "Body/cells=50, 1",
                                        "Solution/largest increment=0.002"});
        EXPECT_EQ(run.status(), "completed");
        EXPECT_EQ(run.number("jumps"), 0.);
        EXPECT_EQ(run.number("bonded area left [mm^2]"), 0.);
        EXPECT_LT(run.number("energy balance error [-]"), .01);

        const double lost   = run.number("adhesion dissipation [mJ]");
        const auto  &stored = run.history["stored energy [mJ]"];
        EXPECT_GT(*std::max_element(stored.begin(), stored.end()), .05 * lost);
        EXPECT_LT(stored.back(), 1e-6 * lost);
        EXPECT_NEAR(run.number("work of demolding [mJ]"), lost, 1e-3 * lost);

        // Of the mixings with G_II = G_I any gap path needs G_c.
        const double exact = area * sheet.work(c, s);
        if (mixing.a == mixing.b * mixing.b)
          {
            EXPECT_NEAR(exact, fracture_energy * area, 1e-4 * exact);
            EXPECT_NEAR(lost, fracture_energy * area, 1e-6 * exact);
          }
        // The free ends of the sheet differ from its middle.
        EXPECT_NEAR(lost, exact, .01 * exact);
        record("dissipation over closed form at " + std::to_string(degree),
               lost / exact);
      }
  }

  INSTANTIATE_TEST_SUITE_P(mixings, ElasticMixedMode, mixings);
} // namespace demold

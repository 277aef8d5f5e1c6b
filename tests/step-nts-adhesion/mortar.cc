// SPDX-License-Identifier: LGPL-2.1-or-later
// Scenes of step-nts-adhesion with one word changed, Contact/formulation =
// mortar: exact where node to segment is not, and rigid until the limit.
#include "step-nts-adhesion/run_nts.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    const Rubber rubber;

    SceneRun run_mortar(const std::string       &scene,
                        std::vector<std::string> overrides = {})
    {
      overrides.push_back("Contact/formulation=mortar");
      return run_nts(scene, overrides);
    }

    class Multipliers : public testing::TestWithParam<std::string>
    {
    protected:
      SceneRun run(const std::string       &scene,
                   std::vector<std::string> overrides = {}) const
      {
        overrides.push_back("Contact/multipliers=" + GetParam());
        return run_mortar(scene, overrides);
      }
    };

    /// Largest deviation of a column from @p exact over @p exact.
    double deviation(const std::vector<double> &values, const double exact)
    {
      double worst = 0.;
      for (const double value : values)
        worst = std::max(worst, std::abs(value / exact - 1.));
      return worst;
    }

    /// Stress at an opening of a confined column in series with a bond that is
    /// rigid until its limit (theory E.1a for an infinite penalty).
    double column_stress(const double opening, const Bond &bond)
    {
      const double height = 8.;
      const auto   length = [&](const double t) {
        return height * (rubber.confined_stretch(t) - 1.);
      };
      if (opening >= bond.rupture)
        return 0.;
      if (opening <= length(bond.strength))
        return root_of([&](double t) { return length(t) - opening; },
                       0.,
                       bond.strength);
      return bond.strength *
             (1. - root_of(
                     [&](double g) {
                       return g - opening +
                              length(bond.strength * (1. - g / bond.rupture));
                     },
                     0.,
                     bond.rupture) /
                     bond.rupture);
    }
  } // namespace

  TEST_P(Multipliers, pass_the_contact_patch_test_on_meshes_that_do_not_match)
  {
    const double   stretch = rubber.uniaxial_stretch(-.1);
    const double   cauchy  = .1 / std::pow(rubber.free_width(stretch), 2);
    const SceneRun result =
      run("contact-patch.prm", {"Solver/residual tolerance=1e-11"});
    EXPECT_EQ(result.status(), "completed");
    const double worst = deviation(result.interface["pressure [MPa]"], cauchy);
    record("largest deviation", worst);
    EXPECT_LT(worst, 1e-10);
  }

  TEST_P(Multipliers, pass_the_adhesion_patch_test_with_a_gap_of_zero)
  {
    const SceneRun result =
      run("adhesion-patch.prm", {"Solver/residual tolerance=1e-11"});
    for (std::size_t i = 0; i < result.interface.n_rows(); ++i)
      {
        EXPECT_NEAR(result.interface["force z [N]"][i] /
                      result.interface["area [mm^2]"][i],
                    -.1,
                    1e-10);
        EXPECT_LT(std::abs(result.interface["gap [mm]"][i]), 1e-10);
      }
  }

  TEST_P(Multipliers, pull_off_follows_the_rigid_limit_of_the_closed_form)
  {
    for (const Bond &bond : {Bond{.2, .1}, Bond{.05, .2}})
      {
        const SceneRun result =
          run("pull-off.prm",
              {"Adhesion/strength=" + std::to_string(bond.strength),
               "Adhesion/rupture gap=" + std::to_string(bond.rupture),
               "Pull/opening=0.25"});
        EXPECT_EQ(result.status(), "completed");
        const auto &force = result.history["force [N]"];
        const auto &u     = result.history["opening [mm]"];
        double      worst = 0.;
        for (std::size_t i = 0; i < force.size(); ++i)
          worst = std::max(worst,
                           std::abs(force[i] - 2. * column_stress(u[i], bond)));
        record("largest deviation over peak", worst / (2. * bond.strength));
        EXPECT_LT(worst, 1e-4 * 2. * bond.strength);
        const double lost = 2. * bond.fracture_energy();
        EXPECT_NEAR(result.number("adhesion dissipation [mJ]"),
                    lost,
                    1e-6 * lost);
      }
  }

  TEST_P(Multipliers, hertz_is_within_one_and_a_half_percent)
  {
    // Johnson 1985, chapter 4, with the small-strain constants of theory A.1.
    const double   lambda = 48.926 + 2. * .20134, G = .80537 + .20134;
    const double   nu     = .5 * lambda / (lambda + G);
    const double   star   = 2. * G * (1. + nu) / (1. - nu * nu);
    const double   a      = std::sqrt(4. * .1 * 10. / (std::acos(-1.) * star));
    const double   p0     = .2 / (std::acos(-1.) * a);
    const SceneRun result = run("hertz.prm");
    EXPECT_EQ(result.status(), "completed");
    const auto &p = result.interface["pressure [MPa]"];
    EXPECT_NEAR(*std::max_element(p.begin(), p.end()), p0, .015 * p0);
  }

  INSTANTIATE_TEST_SUITE_P(Mortar,
                           Multipliers,
                           testing::Values("standard", "dual"));

  TEST(MortarMixedMode, work_at_an_angle_is_that_of_the_law_for_every_mixing)
  {
    struct Mixing
    {
      const char *name;
      double      a, b;
    };
    const double cos2 = .25, sin2 = .75; // 60 degree to the normal
    for (const Mixing &m : {Mixing{"slip limit", .5, 1.},
                            Mixing{"energy", .25, .5},
                            Mixing{"proportional", 1., 2.}})
      {
        const SceneRun result =
          run_mortar("mixed-mode.prm",
                     {std::string("Adhesion/mixing=") + m.name});
        const double G_c = .5 * .2 * .1 * 100.; // 10 x 10 mm
        const double work =
          G_c * (cos2 + m.a * sin2) / (cos2 + m.b * m.b * sin2);
        EXPECT_NEAR(result.number("work of demolding [mJ]"), work, 1e-4 * work)
          << m.name;
        EXPECT_NEAR(result.number("adhesion dissipation [mJ]"),
                    work,
                    1e-4 * work)
          << m.name;
      }
  }

  TEST(MortarPress, carries_the_force_of_the_grip_with_and_without_friction)
  {
    for (const char *friction : {"0", "0.3"})
      {
        const SceneRun result =
          run_mortar("press.prm",
                     {std::string("Friction/coefficient=") + friction});
        EXPECT_EQ(result.status(), "completed") << friction;
        double force = 0.;
        for (const double f : result.interface["force z [N]"])
          force += f;
        EXPECT_NEAR(force,
                    result.number("force at end [N]"),
                    1e-4 * std::abs(force))
          << friction;
      }
  }

  TEST(MortarSlidingBlock, rubs_with_mu_times_the_load_however_it_is_solved)
  {
    for (const char *condensed : {"true", "false"})
      {
        const SceneRun result =
          run_scene(DEMOLD_STEP_MORTAR,
                    DEMOLD_SOURCE_DIR "/prm/step-mortar/sliding-block.prm",
                    {"Adhesion/law=none",
                     "Contact/multipliers=dual",
                     std::string("Contact/condensed=") + condensed});
        const double force = .3 * .1 * 100.; // mu p A [N], pushed by 1 mm
        EXPECT_EQ(result.status(), "completed") << condensed;
        EXPECT_NEAR(result.number("force at end [N]"), force, 1e-3 * force);
        EXPECT_NEAR(result.number("friction dissipation [mJ]"),
                    force,
                    1e-3 * force);
      }
  }
} // namespace demold

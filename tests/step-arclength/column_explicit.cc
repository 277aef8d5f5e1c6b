// SPDX-License-Identifier: LGPL-2.1-or-later
// column-explicit.prm: the column that jumps, by explicit dynamics, against
// implicit dynamics, the path and the closed form.
#include "step-arclength/path_points.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double area = 2., height = 40.; // [mm^2], [mm]

    /// Opening [mm] at which the bond begins to soften.
    double peak_opening()
    {
      const Bond bond;
      return bond.onset() +
             height * (Rubber().confined_stretch(bond.strength) - 1.);
    }

    /// Force [N] at an opening before the peak, between the rows.
    double force_at(const SceneRun &run, const double opening)
    {
      const auto &u = run.history["opening [mm]"];
      const auto &F = run.history["force [N]"];
      for (std::size_t i = 1; i < u.size(); ++i)
        if (u[i] >= opening)
          return F[i - 1] +
                 (F[i] - F[i - 1]) * (opening - u[i - 1]) / (u[i] - u[i - 1]);
      return std::nan("");
    }
  } // namespace

  TEST(ExplicitColumn, agrees_with_implicit_dynamics_and_the_path)
  {
    const SceneRun explicitly = run_arclength("column-explicit.prm");
    ASSERT_EQ(explicitly.status(), "completed");
    const SceneRun implicitly =
      run_arclength("column-explicit.prm",
                    {"Solution/strategy=dynamics",
                     "Solution/largest increment=0.004"});
    ASSERT_EQ(implicitly.status(), "completed");
    const SceneRun path = run_arclength("column.prm");
    ASSERT_EQ(path.exit_code, 0);

    const double peak  = area * Bond().strength;
    double       worst = 0.;
    for (double share = .1; share < .96; share += .05)
      {
        const double u = share * peak_opening();
        const double F = force_at(explicitly, u);
        worst          = std::max({worst,
                                   std::abs(F - force_at(implicitly, u)) / peak,
                                   std::abs(F - force_at(path, u)) / peak});
      }
    record("largest deviation over peak", worst);
    EXPECT_LT(worst, .02);
    EXPECT_NEAR(explicitly.number("peak force [N]"), peak, .02 * peak);
    EXPECT_NEAR(explicitly.number("opening at peak [mm]"),
                peak_opening(),
                .02 * peak_opening());
  }

  TEST(ExplicitColumn, turns_the_released_energy_into_vibration)
  {
    const SceneRun run = run_arclength("column-explicit.prm");
    ASSERT_EQ(run.status(), "completed");
    const Rubber rubber;
    const Bond   bond;
    const double lost    = area * bond.fracture_energy();
    const double stretch = rubber.confined_stretch(bond.strength);
    const double released =
      area * (height * integral_of([&](double l) { return rubber.confined(l); },
                                   1.,
                                   stretch) +
              bond.work(bond.onset()) - bond.fracture_energy());
    EXPECT_NEAR(run.number("adhesion dissipation [mJ]"), lost, 1e-6 * lost);
    EXPECT_NEAR(run.number("work of demolding [mJ]") - lost,
                released,
                .02 * released);
    double kept = 0.;
    for (const char *entry : {"kinetic energy [mJ]",
                              "stored energy [mJ]",
                              "algorithmic dissipation [mJ]",
                              "impact dissipation [mJ]"})
      kept += run.number(entry);
    EXPECT_NEAR(kept, released, .02 * released);
    EXPECT_LT(run.number("energy balance error [-]"), .01);
    EXPECT_LT(run.number("kinetic share up to the peak [-]"), .05);
    EXPECT_GT(run.number("largest kinetic share [-]"), .1);
    EXPECT_EQ(run.number("factorisations"), 0.);
  }
} // namespace demold

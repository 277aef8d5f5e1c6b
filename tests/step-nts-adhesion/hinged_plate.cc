// SPDX-License-Identifier: LGPL-2.1-or-later
// hinged-plate.prm: a rigid plate turned about its end, theory E.2.
#include "step-nts-adhesion/run_nts.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double length = 20., width = 10.; // [mm]

    const Bond bond{.2, .1, 20.};

    /// Chord from the place a node came from, per radius.
    double chord(const double angle)
    {
      return 2. * std::sin(.5 * angle);
    }

    /// Force at the free end: b/L int t(theta x) x dx, by the moments of the
    /// two straight pieces of t.
    double force(const double angle)
    {
      const double first = std::min(length, bond.onset() / angle);
      const double last  = std::min(length, bond.rupture / angle);
      const double slope = bond.strength / (bond.rupture - bond.onset());
      const auto   part  = [&](double x) {
        return slope * (bond.rupture * x * x / 2. - angle * x * x * x / 3.);
      };
      return width / length *
             (bond.penalty * angle * std::pow(first, 3) / 3. + part(last) -
              part(first));
    }

    std::vector<std::string> driven_to(const std::string &angle)
    {
      return {"Supports/motion x=x*(cos(" + angle + ")-1) - y*sin(" + angle +
                ")",
              "Supports/motion y=x*sin(" + angle + ") + y*(cos(" + angle +
                ")-1)",
              "Process/opening=20*(" + angle + ")"};
    }
  } // namespace

  TEST(HingedPlate, closed_form_has_the_values_of_theory_E2)
  {
    EXPECT_NEAR(force(.0005), 13.33333, 1e-5);
    EXPECT_NEAR(force(.001), 17.40741, 1e-5);
    EXPECT_NEAR(force(.0025), 14.51852, 1e-5);
    EXPECT_NEAR(force(.005), 7.333333, 1e-6);
    EXPECT_NEAR(force(.01), 1.833333, 1e-6);
    EXPECT_NEAR(force(.025), .2933333, 1e-7);
  }

  TEST(HingedPlate, has_the_peak_of_the_closed_form_with_forty_elements)
  {
    const SceneRun run = run_nts("hinged-plate.prm");
    EXPECT_EQ(run.status(), "completed");
    EXPECT_NEAR(run.number("peak force [N]"), 17.43459, 1e-3 * 17.43459);
    EXPECT_LT(run.number("energy balance error [-]"), 1e-3);
  }

  // The top of the curve is flat: forty nodes have it 2 % too early.
  TEST(HingedPlate,
       has_the_peak_at_the_angle_of_the_closed_form_with_400_elements)
  {
    const SceneRun run = run_nts("hinged-plate.prm", {"Body/cells=400, 1"});
    EXPECT_NEAR(run.number("peak force [N]"), 17.43459, 1e-4 * 17.43459);
    EXPECT_NEAR(run.number("opening at peak [mm]"),
                length * .00107722,
                length * 1.2e-5); // one increment
  }

  TEST(HingedPlate, follows_the_closed_form_down_to_a_sixtieth_of_the_peak)
  {
    auto overrides = driven_to("0.026*t^2");
    overrides.emplace_back("Body/cells=400, 1");
    const SceneRun run   = run_nts("hinged-plate.prm", overrides);
    double         worst = 0.;
    unsigned int   n     = 0;
    for (std::size_t i = 0; i < run.history.n_rows(); ++i)
      {
        const double angle = run.history["opening [mm]"][i] / length;
        if (angle < .0005)
          continue;
        ++n;
        worst =
          std::max(worst,
                   std::abs(run.history["force [N]"][i] / force(angle) - 1.));
      }
    EXPECT_GT(n, 300u);
    EXPECT_LT(worst, 1e-3);
    record("largest relative deviation", worst);
  }

  TEST(HingedPlate, needs_the_fracture_energy_but_for_the_bonds_at_the_hinge)
  {
    // At the end 0.2 mm are still bonded, less than one of forty elements.
    auto overrides = driven_to("0.5*t^4");
    overrides.emplace_back("Body/cells=400, 1");
    const SceneRun run = run_nts("hinged-plate.prm", overrides);
    const double   c   = chord(.5);
    const double   energy =
      width *
      (bond.fracture_energy() * (length - bond.rupture / c) +
       integral_of([](double g) { return bond.work(g); }, 0., bond.rupture) /
         c);
    EXPECT_GT(energy, .99 * 2.);
    EXPECT_NEAR(run.number("work of demolding [mJ]"), energy, 2e-3 * energy);
    EXPECT_NEAR(run.number("adhesion dissipation [mJ]") +
                  run.number("stored energy [mJ]"),
                energy,
                2e-3 * energy);
  }

  TEST(HingedPlate, closes_the_ledger_when_it_is_of_rubber)
  {
    const SceneRun run =
      run_nts("hinged-plate.prm", {"Supports/driven=top xy"});
    EXPECT_EQ(run.status(), "completed");
    EXPECT_GT(run.number("adhesion dissipation [mJ]"), .5);
    EXPECT_LT(run.number("energy balance error [-]"), .01);
    EXPECT_LT(run.number("peak force [N]"), .99 * 17.43459);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// pull-off.prm: a confined column in series with a bond that is rigid up to
// its limit (theory E.1a, C.4).
#include "step-mortar/run_mortar.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double area = 2., height = 8.; // [mm^2], [mm]
    const Rubber     rubber;

    /// How much longer the column is under a nominal stress [mm].
    double extension(const double stress)
    {
      return height * (rubber.confined_stretch(stress) - 1.);
    }

    /// Stress at an opening.
    double stress(const double opening, const Bond &bond)
    {
      if (opening >= bond.rupture)
        return 0.;
      if (opening <= extension(bond.strength))
        return rubber.confined(1. + opening / height);
      const auto softened = [&](const double gap) {
        return bond.strength * (1. - gap / bond.rupture);
      };
      return softened(
        root_of([&](double g) { return g + extension(softened(g)) - opening; },
                0.,
                bond.rupture));
    }

    Entries entries(const Bond &bond)
    {
      return {"Adhesion/strength=" + std::to_string(bond.strength),
              "Adhesion/rupture gap=" + std::to_string(bond.rupture)};
    }

    double deviation_of_force(const SceneRun &run, const Bond &bond)
    {
      const auto &force = run.history["force [N]"];
      const auto &u     = run.history["opening [mm]"];
      double      worst = 0.;
      for (std::size_t i = 0; i < force.size(); ++i)
        worst = std::max(worst, std::abs(force[i] - area * stress(u[i], bond)));
      return worst / (area * bond.strength);
    }

    class PullOff : public Multipliers
    {};
  } // namespace

  TEST_P(PullOff, follows_the_closed_form_within_a_hundredth_of_a_percent)
  {
    for (const Bond &bond : {Bond{.2, .1}, Bond{.05, .2}})
      {
        const SceneRun result =
          run("pull-off.prm", entries(bond) + Entries{"Pull/opening=0.25"});
        EXPECT_EQ(result.status(), "completed");
        ASSERT_GT(result.history.n_rows(), 80u);
        const double worst = deviation_of_force(result, bond);
        record("largest deviation over peak", worst);
        EXPECT_LT(worst, 1e-4);
        const double lost = area * bond.fracture_energy();
        EXPECT_NEAR(result.number("adhesion dissipation [mJ]"),
                    lost,
                    1e-6 * lost);
        EXPECT_EQ(result.number("bonded area left [mm^2]"), 0.);
        EXPECT_LT(result.number("energy balance error [-]"), 1e-3);
      }
  }

  INSTANTIATE_TEST_SUITE_P(Mortar,
                           PullOff,
                           testing::Values("standard", "dual"));

  // The gap of a penalty is alpha/gamma at the limit, and so is its error.
  TEST(PullOffPenalty, comes_to_the_rigid_bond_like_one_over_the_penalty)
  {
    const Bond    bond{.2, .1};
    const Entries fine{"Solution/largest increment=0.0005"};
    double        error[3];
    unsigned int  i = 0;
    for (const char *penalty : {"200", "2000", "20000"})
      {
        error[i] = deviation_of_force(
          run_node_to_segment("pull-off.prm",
                              fine + Entries{std::string("Adhesion/penalty=") +
                                             penalty}),
          bond);
        record(std::string("deviation with ") + penalty, error[i++]);
      }
    EXPECT_NEAR(error[0] / error[1], 10., 3.);
    EXPECT_NEAR(error[1] / error[2], 10., 3.);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// tread-slice.prm: a tread block followed through all its jumps.
#include "step-arclength/path_points.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    /// G_c times the bonded area [mJ]: 20 mm wide and thick, 8 mm high, draft 3
    /// degree, no sipes.
    double energy_of_the_bond(const double strength, const double rupture_gap)
    {
      const double line = 20. + 2. * 8. / std::cos(3. * M_PI / 180.);
      return .5 * strength * rupture_gap * line * 20.;
    }

    using Entries = std::vector<std::string>;

    SceneRun run_slice(Entries entries)
    {
      entries.push_back("Block/sipes=0");
      return run_arclength("tread-slice.prm", entries);
    }

    void expect_release(const SceneRun &run, const double energy)
    {
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_EQ(run.status(), "completed with jumps");
      EXPECT_EQ(run.number("bonded area left [mm^2]"), 0.);
      EXPECT_NEAR(run.number("adhesion dissipation [mJ]"),
                  energy,
                  .005 * energy);
      EXPECT_LT(run.number("energy balance error [-]"), .01);
      EXPECT_GT(run.number("released energy [mJ]"), 0.);
    }

    /// Force [N] of the last row before @p opening [mm] is reached, linearly.
    double force_at(const SceneRun &run, const double opening)
    {
      const auto &u = run.history["opening [mm]"];
      const auto &F = run.history["force [N]"];
      std::size_t i = 1;
      while (i + 1 < u.size() && u[i] < opening)
        ++i;
      return F[i - 1] +
             (F[i] - F[i - 1]) * (opening - u[i - 1]) / (u[i] - u[i - 1]);
    }
  } // namespace

  TEST(TreadSlice, is_followed_through_its_jumps_with_a_closed_ledger)
  {
    const SceneRun path = run_slice({});
    expect_release(path, energy_of_the_bond(.316228, .0632456));

    // Before the first jump there is one solution only.
    const SceneRun moving =
      run_slice({"Solution/strategy=dynamics", "Solution/accuracy=0.1"});
    for (const double opening : {.01, .02, .03})
      EXPECT_NEAR(force_at(path, opening),
                  force_at(moving, opening),
                  .02 * force_at(moving, opening))
        << opening;
    // A peak between two jumps depends on where the first one ended.
    EXPECT_NEAR(path.number("peak force [N]"),
                moving.number("peak force [N]"),
                .03 * moving.number("peak force [N]"));
  }

  TEST(TreadSlice, no_time_passes_on_the_way_back)
  {
    const SceneRun run      = run_slice({"Pull/opening=0.1"});
    const auto    &viscous  = run.history["viscous dissipation [mJ]"];
    const auto    &clock    = run.history["time [s]"];
    const auto    &opening  = run.history["opening [mm]"];
    unsigned int   back     = 0;
    double         farthest = opening.at(0);
    for (std::size_t i = 1; i < clock.size(); ++i)
      {
        if (opening[i] < farthest)
          {
            EXPECT_EQ(clock[i], clock[i - 1]) << i;
            EXPECT_EQ(viscous[i], viscous[i - 1]) << i;
            ++back;
          }
        farthest = std::max(farthest, opening[i]);
      }
    EXPECT_GT(back, 10u);
    EXPECT_GT(viscous.back(), 0.);
  }

  TEST(TreadSlice, is_followed_where_the_bond_is_a_hundred_times_as_steep)
  {
    expect_release(run_slice({"Adhesion/strength=1",
                              "Adhesion/rupture gap=0.02",
                              "Adhesion/penalty=1000"}),
                   energy_of_the_bond(1., .02));
  }

  // A coarse mesh, a bond a thousand times as steep: between some nodes there
  // is no piece of a path to be found.
  TEST(TreadSlice, slides_where_the_path_cannot_be_followed)
  {
    const SceneRun run = run_slice({"Adhesion/strength=3.16228",
                                    "Adhesion/rupture gap=0.00632456",
                                    "Adhesion/penalty=10000",
                                    "Block/element size=2.5",
                                    "Block/wall element size=2.5"});
    expect_release(run, energy_of_the_bond(3.16228, .00632456));
    const double damped = run.number("regularisation dissipation [mJ]");
    EXPECT_GT(damped, 0.);
    EXPECT_GT(run.number("released energy [mJ]"), damped);
    const auto &taken = run.history["regularisation dissipation [mJ]"];
    for (std::size_t i = 1; i < taken.size(); ++i)
      EXPECT_GE(taken[i], taken[i - 1] * (1. - 1e-9)) << i;
    const std::string events = run.summary.at("events");
    EXPECT_NE(events.find("a slide has led past"), std::string::npos);
  }
} // namespace demold

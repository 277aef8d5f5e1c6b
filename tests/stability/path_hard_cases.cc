// SPDX-License-Identifier: LGPL-2.1-or-later
// Hard cases of path following: each completes with a closed ledger and, where
// there is a closed form, on it.
#include "step-arclength/path_points.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    using Entries = std::vector<std::string>;

    SceneRun run_nts(const std::string &scene,
                     const std::string &strategy,
                     Entries            entries)
    {
      entries.push_back("Solution/strategy=" + strategy);
      entries.push_back("Solution/path constraint=adaptive");
      return run_scene(DEMOLD_STEP_NTS_ADHESION,
                       DEMOLD_SOURCE_DIR "/prm/step-nts-adhesion/" + scene,
                       entries);
    }

    void expect_completed(const SceneRun &run)
    {
      EXPECT_EQ(run.exit_code, 0) << run.summary;
      EXPECT_EQ(run.status().rfind("completed", 0), 0u) << run.summary;
      EXPECT_LT(run.number("energy balance error [-]"), .01) << run.summary;
    }

    void expect_all_let_go(const SceneRun &run)
    {
      expect_completed(run);
      EXPECT_EQ(run.number("bonded area left [mm^2]"), 0.);
    }
  } // namespace

  // u_peak = 20.01 mm and back to delta = 0.1 mm, with increments of 0.5 mm.
  TEST(PathHardCases, a_snap_back_is_sharper_than_any_increment)
  {
    for (const std::string constraint :
         {"dissipation", "largest opening", "interface", "adaptive"})
      {
        const SpringAndBond scene{.01, Bond()};
        const SceneRun      run =
          run_arclength("spring.prm",
                        {"Network/springs=bar grip y 0.01",
                         "Network/end time=25",
                         "Solution/smallest increment=0.01",
                         "Solution/path constraint=" + constraint});
        expect_all_let_go(run);
        EXPECT_NEAR(run.number("released energy [mJ]"),
                    scene.released(),
                    .005 * scene.released())
          << constraint;
        for (const PathRow &row : path_rows(run))
          EXPECT_LT(scene.deviation(row.u, row.F), 1e-3) << constraint;
      }
  }

  // The machine goes back while the bond is half gone: it unloads along its
  // secant, and goes on where it was.
  TEST(PathHardCases, unloading_in_the_middle_of_softening)
  {
    const double   k = 5.;
    const Bond     bond;
    const SceneRun run = run_arclength(
      "spring.prm",
      {"Network/springs=bar grip y 5",
       "Network/motion=if(t<0.075, t, if(t<0.15, 0.15-t, t-0.15))",
       "Network/end time=0.3",
       "Solution/path constraint=adaptive"});
    expect_all_let_go(run);
    // Rows need not meet the turn of the machine: where did it turn?
    double turn = 0., t_turn = 0.;
    for (const PathRow &row : path_rows(run))
      if (row.clock < .15 && row.u > turn)
        {
          turn   = row.u;
          t_turn = row.F;
        }
    EXPECT_NEAR(turn, .075, .003);
    const double        secant = t_turn / (turn - t_turn / k);
    const SpringAndBond scene{k, bond};
    unsigned int        unloads = 0;
    double              lowest  = 1.;
    for (const PathRow &row : path_rows(run))
      {
        const double on_secant =
          std::abs(row.u - row.F / k - row.F / secant) / scene.peak_opening();
        EXPECT_LT(std::min(on_secant, scene.deviation(row.u, row.F)), 1e-3)
          << row.u;
        if (row.adhesion > 1e-4 && row.u < .9 * turn &&
            row.u < .9 * scene.peak_opening())
          {
            EXPECT_LT(on_secant, 1e-3) << row.u;
            lowest = std::min(lowest, row.u);
            ++unloads;
          }
      }
    EXPECT_GT(unloads, 2u);
    EXPECT_LT(lowest, .3 * turn);
    EXPECT_EQ(run.number("released energy [mJ]"), 0.);
  }

  // Both fronts of a whole block are equal up to round-off.
  TEST(PathHardCases, symmetric_fronts_let_go_at_once)
  {
    expect_all_let_go(run_arclength(
      "tread-slice.prm",
      {"Block/symmetry=whole", "Block/sipes=0", "Block/element size=1.5"}));
  }

  // A strip is bent up in its middle: the bond lets go there first.
  TEST(PathHardCases, release_starts_inside)
  {
    const SceneRun run = run_nts("edge-peel.prm",
                                 "arc length",
                                 {"Supports/motion x=0",
                                  "Supports/motion y=10*t*(1-((x-10)/10)^2)",
                                  "Process/opening=10*t",
                                  "Body/cells=30, 4",
                                  "Adhesion/rupture gap=0.05",
                                  "Process/end time=0.05"});
    expect_completed(run);
    double      inside = 1e300, outside = 1e300; // first to let go [s]
    const auto &x    = run.interface["x [mm]"];
    const auto &when = run.interface["separation time [s]"];
    const auto &left = run.interface["bonded [-]"];
    for (std::size_t i = 0; i < x.size(); ++i)
      if (left[i] == 0. && std::abs(x[i] - 10.) < 1.)
        inside = std::min(inside, when[i]);
      else if (left[i] == 0. && std::abs(x[i] - 10.) > 9.)
        outside = std::min(outside, when[i]);
    EXPECT_LT(inside, outside);
    EXPECT_LT(inside, 1.);
  }

  // Pressed and pushed: the bond lets go in jumps, friction remains.
  TEST(PathHardCases, friction_holds_what_adhesion_let_go)
  {
    const auto run = [](const std::string &strategy, const Entries &bond) {
      Entries entries = {"Supports/driven=top xy",
                         "Body/size=10, 4",
                         "Supports/motion x=if(t<1,0,2*(t-1))",
                         "Process/opening=max(2*(t-1), 0)"};
      entries.insert(entries.end(), bond.begin(), bond.end());
      return run_nts("sliding-block.prm", strategy, entries);
    };
    const SceneRun bonded =
      run("arc length", {"Adhesion/rupture gap=0.01", "Adhesion/penalty=400"});
    const SceneRun rubbing = run("quasi-static", {"Adhesion/law=none"});
    expect_all_let_go(bonded);
    expect_completed(rubbing);
    EXPECT_GT(bonded.number("jumps"), 0.);
    EXPECT_GT(bonded.number("peak force [N]"),
              1.5 * rubbing.number("peak force [N]"));
    EXPECT_NEAR(bonded.number("force at end [N]"),
                rubbing.number("force at end [N]"),
                .01 * rubbing.number("force at end [N]"));
  }

  // One material, three strategies: relaxation times of 1e-6 to 1e4 s beside a
  // process of 0.1 s.
  TEST(PathHardCases, relaxation_times_over_10_decades)
  {
    double peak = 0.;
    for (const std::string strategy : {"arc length", "dynamics", "automatic"})
      {
        const SceneRun run =
          run_arclength("tread-slice.prm",
                        {"Block/sipes=0",
                         "Adhesion/strength=0.1",
                         "Adhesion/rupture gap=0.2",
                         "Adhesion/penalty=20",
                         "Material/relaxation times="
                         "1e-6, 1e-5, 1e-3, 1e-2, 1, 10, 1000, 1e4",
                         "Solution/strategy=" + strategy});
        expect_all_let_go(run);
        if (peak == 0.)
          peak = run.number("peak force [N]");
        EXPECT_NEAR(run.number("peak force [N]"), peak, .02 * peak) << strategy;
      }
  }
} // namespace demold

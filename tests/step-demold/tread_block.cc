// SPDX-License-Identifier: LGPL-2.1-or-later
// The tread block leaves its mould: what is lost equals what was bonded.
#include "step-demold/demolding.h"

namespace demold
{
  namespace
  {
    /// At least 1 mm beyond the last touch.
    void expect_release_and_way_beyond(const SceneRun &run)
    {
      expect_clean_release(run);
      double last_touch = 0.;
      for (std::size_t i = 0; i < run.history.n_rows(); ++i)
        if (run.history["bonded area [mm^2]"][i] > 0. ||
            run.history["touching area [mm^2]"][i] > 0.)
          last_touch = run.history["opening [mm]"][i];
      EXPECT_GE(run.number("opening at end [mm]"), last_touch + 1.);
    }
  } // namespace

  TEST(TreadBlock, slice_loses_the_fracture_energy_of_its_bonded_line)
  {
    for (const unsigned int sipes : {0u, 2u})
      {
        const SceneRun run =
          run_demold("slice.prm", {"Block/sipes=" + std::to_string(sipes)});
        expect_release_and_way_beyond(run);
        const double energy = G_c * bonded_line(sipes) * 20.;
        EXPECT_NEAR(run.number("adhesion dissipation [mJ]"),
                    energy,
                    .005 * energy);
      }
  }

  TEST(TreadBlock, half_slice_reports_the_whole_block)
  {
    const SceneRun half  = run_demold("slice.prm", {});
    const SceneRun whole = run_demold("slice.prm", {"Block/symmetry=whole"});
    expect_release_and_way_beyond(whole);
    EXPECT_NEAR(whole.number("peak force [N]"),
                half.number("peak force [N]"),
                .005 * half.number("peak force [N]"));
    EXPECT_NEAR(whole.number("work of demolding [mJ]"),
                half.number("work of demolding [mJ]"),
                .005 * half.number("work of demolding [mJ]"));
  }

  TEST(TreadBlock, coarse_quarter_block_loses_the_energy_of_its_bonded_area)
  {
    const SceneRun run = run_demold("tread-block.prm",
                                    {"Block/element size=2.5",
                                     "Block/wall element size=1.2",
                                     "Mould/facet size=2"});
    expect_release_and_way_beyond(run);
    // Bottom without slot mouths; two walls along the sipes, two across them
    // less the slots they lose; flanks and tips of the slots, which follow the
    // draft of the walls at their ends.
    const double t = std::tan(3. * degree), c = std::cos(3. * degree);
    const double wall         = (20. + 8. * t) * 8. / c;
    const double s            = std::tan(.5 * degree);
    const double slot_in_wall = (.6 + (.6 - 2. * 6. * s)) / 2. * 6. / c;
    const double flank = 2. * (20. + 6. * t) * 6. / std::cos(.5 * degree);
    const double tip   = (.6 - 2. * 6. * s) * (20. + 2. * 6. * t);
    const double area =
      400. - 2. * .6 * 20. + 4. * wall + 2. * (flank + tip - 2. * slot_in_wall);
    EXPECT_NEAR(run.number("adhesion dissipation [mJ]"),
                G_c * area,
                .005 * G_c * area);
  }

  TEST(TreadBlock, friction_does_work_under_an_inclined_pull)
  {
    const SceneRun run = run_demold("slice.prm",
                                    {"Block/symmetry=whole",
                                     "Pull/inclination=2",
                                     "Solution/accuracy=0.1"});
    expect_release_and_way_beyond(run);
    EXPECT_GT(run.number("friction dissipation [mJ]"), 1.);
  }

  TEST(TreadBlock, dynamics_and_statics_agree_where_nothing_jumps)
  {
    const SceneRun dynamic = run_demold("slice.prm");
    const SceneRun still =
      run_demold("slice.prm", {"Solution/strategy=quasi-static"});
    EXPECT_NEAR(still.number("peak force [N]"),
                dynamic.number("peak force [N]"),
                .01 * dynamic.number("peak force [N]"));
  }

  TEST(TreadBlock, effects_that_are_off_hold_no_history)
  {
    const SceneRun elastic =
      run_scene(DEMOLD_STEP_NTS_ADHESION,
                DEMOLD_SOURCE_DIR "/prm/step-nts-adhesion/block.prm",
                {"Body/cells=3, 3, 3"});
    EXPECT_EQ(elastic.number("history [MiB]"), 0.);
    EXPECT_EQ(elastic.number("time contact [s]"), 0.);
  }
} // namespace demold

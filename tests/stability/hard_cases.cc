// SPDX-License-Identifier: LGPL-2.1-or-later
// Hard cases: each either completes with a closed ledger or stops with a
// reason; none hangs, produces NaN or is silently wrong.
#include "run_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace demold
{
  namespace
  {
    using Entries = std::vector<std::string>;

    SceneRun run_slice(const Entries &overrides)
    {
      return run_scene(DEMOLD_STEP_DEMOLD,
                       DEMOLD_SOURCE_DIR "/prm/step-demold/slice.prm",
                       overrides);
    }

    SceneRun run_nts(const std::string &scene, const Entries &overrides)
    {
      return run_scene(DEMOLD_STEP_NTS_ADHESION,
                       DEMOLD_SOURCE_DIR "/prm/step-nts-adhesion/" + scene,
                       overrides);
    }

    void expect_completed(const SceneRun &run)
    {
      EXPECT_EQ(run.exit_code, 0) << run.summary;
      EXPECT_EQ(run.status().rfind("completed", 0), 0u) << run.summary;
      EXPECT_LT(run.number("energy balance error [-]"), .01) << run.summary;
      for (const double force : run.history["force [N]"])
        ASSERT_TRUE(std::isfinite(force));
    }

    void expect_completed_or_reason(const SceneRun &run)
    {
      if (run.exit_code == 0)
        return expect_completed(run);
      EXPECT_EQ(run.exit_code, 1);
      EXPECT_EQ(run.status(), "gave up");
      EXPECT_GT(run.summary.at("reason").get<std::string>().size(), 20u);
    }

    /// The elastic block of sliding-block.prm without bonds, held at its top.
    Entries elastic_block(const std::string &x, const std::string &y)
    {
      return {"Supports/driven=top xy",
              "Adhesion/law=none",
              "Supports/motion x=" + x,
              "Supports/motion y=" + y,
              "Process/opening=t",
              "Solution/largest increment=0.02"};
    }

    Entries operator+(Entries a, const Entries &b)
    {
      a.insert(a.end(), b.begin(), b.end());
      return a;
    }

    std::string strategy(const std::string &name)
    {
      return "Solution/strategy=" + name;
    }
  } // namespace

  TEST(HardCases, steep_softening_completes_with_dynamics)
  {
    expect_completed(run_slice({"Adhesion/rupture gap=0.02"}));
  }

  TEST(HardCases, contact_penalties_from_1e2_to_1e5_complete)
  {
    for (const std::string penalty : {"1e2", "1e3", "1e4", "1e5"})
      {
        const std::string entry = "Contact/penalty=" + penalty;
        expect_completed(run_nts("hertz.prm", {entry}));
        expect_completed(
          run_nts("pull-off.prm",
                  {entry, "Pull/velocity=2*cos(2*pi*t)", "Pull/opening=1.2"}));
      }
  }

  TEST(HardCases, contact_penalties_of_1e6_and_1e7_complete_or_say_why_not)
  {
    for (const std::string penalty : {"1e6", "1e7"})
      {
        const std::string entry = "Contact/penalty=" + penalty;
        expect_completed_or_reason(run_nts("hertz.prm", {entry}));
        expect_completed_or_reason(
          run_nts("pull-off.prm",
                  {entry, "Pull/velocity=2*cos(2*pi*t)", "Pull/opening=1.2"}));
      }
  }

  TEST(HardCases, nearly_incompressible_rubber_completes_with_q1p0)
  {
    expect_completed(run_slice({"Material/lambda=2500"}));
  }

  TEST(HardCases, nearly_incompressible_rubber_locks_but_ends_with_q1)
  {
    expect_completed_or_reason(
      run_slice({"Material/lambda=2500", "element=q1"}));
  }

  TEST(HardCases, a_block_slides_off_the_end_of_the_master)
  {
    for (const std::string friction : {"0", "0.3"})
      expect_completed(run_nts("sliding-block.prm",
                               elastic_block("8*max(t-1,0)", "-0.05*min(t,1)") +
                                 Entries{"Friction/coefficient=" + friction,
                                         "Mould/to=14",
                                         "Solution/largest increment=0.01"}));
  }

  TEST(HardCases, a_block_in_space_crosses_edges_and_a_corner_of_the_master)
  {
    expect_completed(run_nts("sliding-block.prm",
                             elastic_block("3*max(t-1,0)", "1.5*max(t-1,0)") +
                               Entries{"dimension=3",
                                       "Supports/driven=top xyz",
                                       "Supports/motion z=-0.05*min(t,1)",
                                       "Body/lower corner=0, 0, 0",
                                       "Body/size=6, 4, 2",
                                       "Body/cells=5, 4, 2",
                                       "Mould/from=-5, -3",
                                       "Mould/to=7.3, 4.4",
                                       "Mould/facets=7, 5"}));
  }

  TEST(HardCases, a_block_is_pushed_into_a_corner_of_90_degree)
  {
    for (const std::string name : {"quasi-static", "dynamics"})
      expect_completed(run_nts("sliding-block.prm",
                               elastic_block("-0.3*t", "-0.2*t") +
                                 Entries{"Body/slave=bottom, left",
                                         "Mould/shape=polyline",
                                         "Mould/corners=20, 0; 0, 0; 0, 10",
                                         "Mould/facets=7",
                                         "Process/end time=1",
                                         strategy(name)}));
  }

  TEST(HardCases, separation_and_renewed_contact_complete)
  {
    for (const std::string name : {"quasi-static", "dynamics"})
      {
        const SceneRun run = run_nts("pull-off.prm",
                                     {"Pull/velocity=2*cos(2*pi*t)",
                                      "Pull/opening=1.2",
                                      "Friction/coefficient=0.3",
                                      "Solution/largest increment=0.005",
                                      strategy(name)});
        expect_completed(run);
        // G_c A = 0.01 mJ/mm^2 times 2 mm^2, lost once and for all
        EXPECT_NEAR(run.number("adhesion dissipation [mJ]"), .02, 1e-6);
        EXPECT_EQ(run.number("bonded area left [mm^2]"), 0.);
        const auto &force = run.history["force [N]"];
        EXPECT_LT(*std::min_element(force.begin(), force.end()), -1.);
      }
  }

  TEST(HardCases, zero_and_large_friction_complete)
  {
    for (const std::string friction : {"0", "5"})
      for (const std::string name : {"quasi-static", "dynamics"})
        expect_completed(run_nts(
          "sliding-block.prm",
          elastic_block("0.3*max(t-1,0)", "-0.02*min(t,1)") +
            Entries{"Friction/coefficient=" + friction, strategy(name)}));
  }

  TEST(HardCases, increments_of_a_microsecond_complete_without_false_work)
  {
    const SceneRun run  = run_slice({"Solution/first increment=1e-6",
                                     "Solution/largest increment=1e-5",
                                     "Solution/growth=1",
                                     "Pull/opening=0.005"});
    const double   work = run.number("work of demolding [mJ]");
    expect_completed(run);
    EXPECT_GT(work, 0.);
    EXPECT_LT(std::abs(run.number("algorithmic dissipation [mJ]")),
              1e-4 * work);
    EXPECT_LT(std::abs(run.number("impact dissipation [mJ]")), 1e-4 * work);
  }

  TEST(HardCases, the_whole_opening_in_one_increment_completes_or_says_why)
  {
    for (const std::string name : {"quasi-static", "dynamics"})
      expect_completed_or_reason(run_slice({"Solution/first increment=1",
                                            "Solution/largest increment=1",
                                            strategy(name)}));
  }

  TEST(HardCases, where_no_equilibrium_is_near_the_reason_names_the_remedy)
  {
    const SceneRun run =
      run_slice({"Adhesion/rupture gap=0.02", strategy("quasi-static")});
    expect_completed_or_reason(run);
    if (run.exit_code == 1)
      EXPECT_NE(run.summary.at("reason").get<std::string>().find(
                  "Solution/strategy = automatic"),
                std::string::npos);
  }
} // namespace demold

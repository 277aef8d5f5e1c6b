// SPDX-License-Identifier: LGPL-2.1-or-later
// What must not matter: which body is the slave, how everything is turned, and,
// on fine meshes, the formulation.
#include "step-mortar/run_mortar.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    /// Value of a column at an opening, linear between rows.
    double at_opening(const CsvTable    &history,
                      const std::string &column,
                      const double       opening)
    {
      const auto &u = history["opening [mm]"];
      const auto &f = history[column];
      const auto  i = static_cast<std::size_t>(
        std::lower_bound(u.begin(), u.end(), opening) - u.begin());
      if (i == 0)
        return f.front() * opening / u.front();
      if (i == u.size())
        return f.back();
      const double part = (opening - u[i - 1]) / (u[i] - u[i - 1]);
      return f[i - 1] + part * (f[i] - f[i - 1]);
    }

    SceneRun run_edge_peel(const Entries &overrides)
    {
      return run_scene(DEMOLD_STEP_MORTAR,
                       DEMOLD_SOURCE_DIR "/prm/step-nts-adhesion/edge-peel.prm",
                       overrides);
    }

    /// A mould that can be a slave: a stiff base with nodes at the ends of the
    /// block, so that the bond ends there for either slave.
    const Entries stiff_mould = {"Base/present=true",
                                 "Base/lower corner=-2, -4",
                                 "Base/size=24, 4",
                                 "Base/cells=72, 6",
                                 "Base/modulus=1000",
                                 "Base/bulk modulus=1000",
                                 "Supports/held=base bottom xy"};
  } // namespace

  TEST(Exchange, of_slave_and_master_changes_the_force_by_less_than_a_percent)
  {
    const SceneRun rubber =
      run_edge_peel(stiff_mould + Entries{"Body/slave=bottom"});
    const SceneRun mould =
      run_edge_peel(stiff_mould + Entries{"Body/slave=base top",
                                          "Adhesion/bonded where=if(abs(x-10)<="
                                          "10,1,0)"});
    EXPECT_EQ(rubber.status(), "completed");
    EXPECT_EQ(mould.status(), "completed");
    const double peak  = rubber.number("peak force [N]");
    double       worst = 0.;
    for (const double u : rubber.history["opening [mm]"])
      worst = std::max(worst,
                       std::abs(at_opening(rubber.history, "force [N]", u) -
                                at_opening(mould.history, "force [N]", u)));
    record("largest difference over peak", worst / peak);
    EXPECT_LT(worst, .01 * peak);
  }

  TEST(Exchange,
       of_the_formulation_changes_peak_and_loss_by_less_than_3_percent)
  {
    const Entries  fine{"Body/cells=120, 12"};
    const SceneRun mortar = run_edge_peel(fine);
    const SceneRun nodes =
      run_edge_peel(fine + Entries{"Contact/formulation=node to segment",
                                   "Adhesion/penalty=100"});
    for (const char *entry : {"peak force [N]", "adhesion dissipation [mJ]"})
      {
        record(entry, mortar.number(entry) / nodes.number(entry) - 1.);
        EXPECT_NEAR(mortar.number(entry),
                    nodes.number(entry),
                    .03 * nodes.number(entry));
      }
  }

  // Both blocks are stretched by 2 %, then turned by 30 degree.
  TEST(RigidMotion, of_two_bonded_blocks_leaves_their_tractions_as_they_are)
  {
    const std::string height = "(y+0.2*min(t,1)*if(y>0,1,0))";
    const std::string angle  = "(pi/6*max(t-1,0))";
    const Entries     blocks{"dimension=2",
                         "Body/lower corner=0, 0",
                         "Body/size=10, 5",
                         "Body/cells=17, 5",
                         "Base/lower corner=0, -5",
                         "Base/size=10, 5",
                         "Base/cells=11, 4",
                         "Adhesion/strength=2",
                         "Adhesion/rupture gap=0.2",
                         "Supports/held=",
                         "Supports/driven=top xy, base bottom xy",
                         "Supports/motion x=x*cos" + angle + "-" + height +
                           "*sin" + angle + "-x",
                         "Supports/motion y=x*sin" + angle + "+" + height +
                           "*cos" + angle + "-y",
                         "Supports/traction boundary=",
                         "Process/direction=0, 1, 0",
                         "Process/force on=top",
                         "Solution/largest increment=0.05",
                         "Solver/residual tolerance=1e-11"};
    const auto        tractions = [&](const std::string &end) {
      const SceneRun run =
        run_mortar("adhesion-patch.prm",
                   blocks + Entries{"Process/end time=" + end});
      EXPECT_EQ(run.status(), "completed");
      const auto          x = traction(run, "x"), y = traction(run, "y");
      std::vector<double> norms;
      for (std::size_t i = 0; i < x.size(); ++i)
        norms.push_back(std::hypot(x[i], y[i]));
      return norms;
    };
    const auto before = tractions("1"), after = tractions("2");
    ASSERT_EQ(before.size(), after.size());
    double worst = 0.;
    for (std::size_t i = 0; i < before.size(); ++i)
      worst = std::max(worst, std::abs(after[i] / before[i] - 1.));
    record("largest change", worst);
    EXPECT_GT(largest(before), .01);
    EXPECT_LT(worst, 1e-10);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// ironing.prm: a round indenter dragged along a soft slab.
#include "step-mortar/run_mortar.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    /// Horizontal over vertical force at the end.
    double global_friction(const SceneRun &run)
    {
      double x = 0., y = 0.;
      for (std::size_t i = 0; i < run.interface.n_rows(); ++i)
        {
          x += run.interface["force x [N]"][i];
          y += run.interface["force y [N]"][i];
        }
      return std::abs(x / y);
    }

    /// Standard deviation of the horizontal force over its mean, from 0.4 mm
    /// of the way on: by then it is steady but for the slab's nodes.
    double oscillation(const SceneRun &run)
    {
      double sum = 0., squares = 0., n = 0.;
      for (std::size_t i = 0; i < run.history.n_rows(); ++i)
        if (run.history["opening [mm]"][i] > 1.)
          {
            const double f = run.history["force [N]"][i];
            sum += f;
            squares += f * f;
            n += 1.;
          }
      const double mean = sum / n;
      return std::sqrt(std::max(0., squares / n - mean * mean)) /
             std::abs(mean);
    }
  } // namespace

  // Poulios and Renard 2015 0.30, Batistic et al. 2022 0.32, Houssein 2022
  // 0.32, Code_Aster SSNP153 0.34, Hartmann et al. 2009 0.38, Yastrebov 2011
  // 0.47, Fischer and Wriggers 2006 0.53.
  TEST(Ironing, has_a_global_friction_in_the_published_band)
  {
    const SceneRun run = run_mortar("ironing.prm", {"Process/end time=1.5"});
    EXPECT_EQ(run.status(), "completed");
    const double friction = global_friction(run);
    record("global friction", friction);
    EXPECT_GT(friction, .3);
    EXPECT_LT(friction, .53);
  }

  TEST(Ironing, oscillates_less_than_node_to_segment_does)
  {
    // as deep, and with penalties as high, as node to segment gets by
    const Entries  short_way{"Process/end time=1.8",
                            "Supports/motion y=-0.3*min(t,1)",
                            "Contact/penalty=300",
                            "Friction/penalty=300"};
    const SceneRun mortar = run_mortar("ironing.prm", short_way);
    EXPECT_EQ(mortar.status(), "completed");
    const SceneRun nodes = run_node_to_segment("ironing.prm", short_way);
    record("mortar", oscillation(mortar));
    record("node to segment", oscillation(nodes));
    EXPECT_LT(oscillation(mortar), oscillation(nodes));
  }
} // namespace demold

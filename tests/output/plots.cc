// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures come from the history, or their absence is explained.
#include "output/plots.h"

#include "scratch_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace demold
{
  namespace
  {
    const LinePlot force = {"force-over-opening",
                            "Demolding \"force\"",
                            "opening [mm]",
                            {"force [N]"},
                            "force [N]"};
    const LinePlot both  = {"both",
                            "Both",
                            "opening [mm]",
                            {"force [N]", "work [mJ]"},
                            "N, mJ"};

    constexpr auto history = "opening [mm],force [N],work [mJ],strategy\n"
                             "0,0,0,a\n1,2,1,a\n2,1,2.5,\"b, c\"\n";

    bool gnuplot_is_there()
    {
      return std::system("gnuplot --version >/dev/null 2>&1") == 0;
    }

    TEST(Plots, labels_carry_units)
    {
      const auto script = plot_script(force);
      EXPECT_TRUE(contains(script, "set xlabel \"opening [mm]\""));
      EXPECT_TRUE(contains(script, "set ylabel \"force [N]\""));
      EXPECT_TRUE(contains(script, "\"Demolding \\\"force\\\"\""));
      EXPECT_TRUE(contains(plot_script(TimeBreakdown{}), "time [s]"));
    }

    TEST(Plots, pictures_are_drawn_and_scripts_stay)
    {
      if (!gnuplot_is_there())
        GTEST_SKIP() << "no gnuplot here";
      ScratchFolder folder;
      folder.write("history.csv", history);
      EXPECT_EQ(draw_plots(folder.path,
                           {force, both},
                           {{"assembly", 1.}, {"linear solver", 3.}}),
                "");
      for (const char *const name :
           {"force-over-opening", "both", "time-breakdown"})
        {
          const auto svg = folder.read("plots/" + std::string(name) + ".svg");
          EXPECT_TRUE(contains(svg, "</svg>")) << name;
          EXPECT_FALSE(folder.read(std::string(name) + ".gp").empty());
        }
      EXPECT_TRUE(
        contains(folder.read("plots/force-over-opening.svg"), "opening [mm]"));
    }

    TEST(Plots, a_picture_that_fails_is_named)
    {
      if (!gnuplot_is_there())
        GTEST_SKIP() << "no gnuplot here";
      ScratchFolder folder; // without a history
      const auto    message = draw_plots(folder.path, {force}, {});
      EXPECT_TRUE(contains(message, "force-over-opening.gp")) << message;
    }

    TEST(Plots, a_missing_gnuplot_is_said_and_the_scripts_stay)
    {
      ScratchFolder     folder;
      const std::string path = std::getenv("PATH");
      setenv("PATH", folder.path.c_str(), 1);
      const auto message = draw_plots(folder.path, {force, both}, {});
      setenv("PATH", path.c_str(), 1);
      EXPECT_TRUE(contains(message, "gnuplot is not installed")) << message;
      EXPECT_EQ(folder.read("force-over-opening.gp"), plot_script(force));
      EXPECT_EQ(folder.read("both.gp"), plot_script(both));
    }
  } // namespace
} // namespace demold

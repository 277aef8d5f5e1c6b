// SPDX-License-Identifier: LGPL-2.1-or-later
// contact-patch.prm, adhesion-patch.prm, contact-patch-curved.prm: mortar
// passes the patch tests that one-pass node to segment fails (theory E.10).
#include "step-mortar/run_mortar.h"

#include <gtest/gtest.h>

#include <iostream>

namespace demold
{
  namespace
  {
    constexpr double nominal = .1; // [MPa]
    const Rubber     rubber;

    const Entries exactly{"Solver/residual tolerance=1e-11"};

    /// Cauchy pressure [MPa] at a nominal one of 0.1 MPa, all sides free.
    double cauchy_pressure()
    {
      const double stretch = rubber.uniaxial_stretch(-nominal);
      return nominal / std::pow(rubber.free_width(stretch), 2);
    }

    /// The blocks of contact-patch.prm as plates, in plane strain.
    const Entries plates = {"dimension=2",
                            "Body/lower corner=0, 0",
                            "Body/size=10, 5",
                            "Body/cells=17, 5",
                            "Base/lower corner=0, -5",
                            "Base/size=10, 5",
                            "Base/cells=11, 4",
                            "Supports/held=left x, base left x, base bottom y",
                            "Supports/traction=0, -0.1*t, 0",
                            "Process/direction=0, -1, 0"};

    /// The same with free sides: width, thickness kept, under nominal stress.
    double plane_pressure()
    {
      // F = diag(q, l, 1) with S = 0 along q.
      const auto S = [](double C, double q, double l) {
        const double J2 = q * q * l * l;
        return rubber.mu1 + rubber.mu2 * (q * q + l * l + 1. - C) +
               (.5 * rubber.lambda * (J2 - 1.) - rubber.mu1 - 2. * rubber.mu2) /
                 C;
      };
      const auto width = [&](double l) {
        return root_of([&](double q) { return S(q * q, q, l); }, .5, 2.);
      };
      const double l =
        root_of([&](double x) { return x * S(x * x, width(x), x) + nominal; },
                .7,
                1.5);
      return nominal / width(l);
    }

    /// Pressure [MPa] of plane-strain rubber with the stretch @p l in both
    /// directions of the plane.
    double equal_pressure(const double l)
    {
      const double C = l * l;
      return -(
        rubber.mu1 + rubber.mu2 * (C + 1.) +
        (.5 * rubber.lambda * (C * C - 1.) - rubber.mu1 - 2. * rubber.mu2) / C);
    }

    /// Root mean square of the pressure's deviation from @p exact [-].
    double scatter(const SceneRun &run, const double exact)
    {
      double sum = 0., area = 0.;
      for (std::size_t i = 0; i < run.interface.n_rows(); ++i)
        {
          const double A = run.interface["area [mm^2]"][i];
          sum +=
            A * std::pow(run.interface["pressure [MPa]"][i] / exact - 1., 2);
          area += A;
        }
      return std::sqrt(sum / area);
    }

    class Patch : public Multipliers
    {};
  } // namespace

  TEST(PatchClosedForms, have_the_values_of_theory_E10)
  {
    EXPECT_NEAR(cauchy_pressure(), .09387382, 1e-8);
    EXPECT_NEAR(rubber.uniaxial_stretch(nominal), 1.07255867, 1e-8);
    EXPECT_NEAR(equal_pressure(1.), 0., 1e-14);
  }

  TEST_P(Patch, has_the_pressure_in_every_node_in_space)
  {
    const SceneRun result = run("contact-patch.prm", exactly);
    EXPECT_EQ(result.status(), "completed");
    const double worst =
      deviation(result.interface["pressure [MPa]"], cauchy_pressure());
    record("largest deviation", worst);
    EXPECT_LT(worst, 1e-10);
    EXPECT_LT(deviation(traction(result, "z"), nominal), 1e-10);
    EXPECT_LT(largest(traction(result, "x")), 1e-10 * nominal);
  }

  TEST_P(Patch, has_the_pressure_in_every_node_in_the_plane)
  {
    const SceneRun result = run("contact-patch.prm", plates + exactly);
    const double   worst =
      deviation(result.interface["pressure [MPa]"], plane_pressure());
    record("largest deviation", worst);
    EXPECT_LT(worst, 1e-10);
  }

  TEST_P(Patch, bonded_has_the_tension_in_every_node_and_no_gap)
  {
    const SceneRun result = run("adhesion-patch.prm", exactly);
    EXPECT_EQ(result.status(), "completed");
    const double worst = deviation(traction(result, "z"), -nominal);
    record("largest deviation", worst);
    EXPECT_LT(worst, 1e-10);
    EXPECT_LT(largest(result.interface["gap [mm]"]), 1e-10);
    EXPECT_EQ(result.number("adhesion dissipation [mJ]"), 0.);
  }

  // Simple shear keeps the volume; its normal stresses are held by the sides.
  TEST_P(Patch, bonded_has_the_shear_in_every_node_and_no_gap)
  {
    const double   shear = .1; // gamma
    const SceneRun result =
      run("adhesion-patch.prm",
          exactly +
            Entries{"Body/cells=9, 7, 3",
                    "Base/cells=6, 4, 2",
                    "Supports/held=",
                    "Supports/driven=left xyz, right xyz, front xyz, back "
                    "xyz, top xyz, base left xyz, base right xyz, base "
                    "front xyz, base back xyz, base bottom xyz",
                    "Supports/motion x=0.1*t*z",
                    "Supports/traction boundary=",
                    "Process/direction=1, 0, 0",
                    "Process/force on=top"});
    EXPECT_EQ(result.status(), "completed");
    const double exact = (rubber.mu1 + rubber.mu2) * shear;
    // Dual multipliers of driven nodes leave all to the supports.
    const bool   dual  = GetParam() == "dual";
    double       worst = 0.;
    unsigned int n     = 0;
    const auto   force = traction(result, "x");
    for (std::size_t i = 0; i < force.size(); ++i)
      {
        const double x = result.interface["x [mm]"][i];
        const double y = result.interface["y [mm]"][i];
        if (dual && std::min(std::min(x, y), 10. - std::max(x, y)) < 1e-6)
          continue;
        ++n;
        worst = std::max(worst, std::abs(force[i] / exact + 1.));
      }
    EXPECT_GT(n, 10u);
    record("largest deviation", worst);
    EXPECT_LT(worst, 1e-8);
  }

  // At first order, as faces replace the curve.
  TEST_P(Patch, comes_closer_to_the_pressure_on_a_wavy_interface)
  {
    const double        exact = equal_pressure(.99);
    std::vector<double> scatters;
    for (const unsigned int n : {1, 2, 4})
      {
        const auto     text = [&](int k) { return std::to_string(k * n); };
        const SceneRun result =
          run("contact-patch-curved.prm",
              {"Body/cells=" + text(17) + ", " + text(8),
               "Base/cells=" + text(11) + ", " + text(5)});
        EXPECT_EQ(result.status(), "completed");
        const double now = scatter(result, exact);
        record("scatter with " + text(17) + " elements", now);
        scatters.push_back(now);
      }
    EXPECT_LT(scatters.front(), .02);
    EXPECT_LT(scatters[1], scatters[0]);
    EXPECT_LT(scatters[2], .25 * scatters[0]);
  }

  INSTANTIATE_TEST_SUITE_P(Mortar, Patch, testing::Values("standard", "dual"));

  // The table of both formulations.
  TEST(PatchTable, node_to_segment_misses_what_mortar_has)
  {
    const std::string scene = "contact-patch.prm";
    const double mortar = deviation(traction(run_mortar(scene), "z"), nominal);
    const double nodes =
      deviation(traction(run_node_to_segment(scene), "z"), nominal);
    std::cout << "largest deviation of the pressure [-]\n"
              << "  mortar           " << (mortar < 1e-8 ? "< 1e-8" : "larger")
              << "\n  node to segment  " << std::round(100. * nodes) / 100.
              << "\n";
    EXPECT_LT(mortar, 1e-8);
    EXPECT_GT(nodes, .01);
  }
} // namespace demold

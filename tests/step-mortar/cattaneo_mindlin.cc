// SPDX-License-Identifier: LGPL-2.1-or-later
// cattaneo-mindlin.prm: partial slip of a cylinder (Cattaneo 1938, Mindlin
// 1949; Johnson 1985, chapter 7).
#include "hertz_ellipse.h"
#include "step-mortar/run_mortar.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double mu       = .5;
    constexpr double sticking = 4.; // state of theory C.5

    struct Forces
    {
      double P = 0., Q = 0.; // [N]
      double centre = 0.;    // [mm] of pressure
    };

    Forces sum(const CsvTable &points)
    {
      Forces result;
      for (std::size_t i = 0; i < points.n_rows(); ++i)
        {
          result.P += points["force y [N]"][i];
          result.Q += std::abs(points["force x [N]"][i]);
          result.centre += points["force y [N]"][i] * points["x [mm]"][i];
        }
      result.centre /= result.P;
      return result;
    }

    /// Half-width of the zone that sticks, from its points: there
    /// (mu p - q)^2 = (mu p_0/a)^2 (c^2 - x^2), x from the centre of pressure,
    /// which moves as the cylinder rolls.
    double stick_half_width(const CsvTable &points, const double centre)
    {
      double n = 0., X = 0., Y = 0., XX = 0., XY = 0.;
      for (std::size_t i = 0; i < points.n_rows(); ++i)
        {
          const double A = points["area [mm^2]"][i];
          const double p = points["force y [N]"][i] / A;
          const double q = std::abs(points["force x [N]"][i]) / A;
          if (points["state [-]"][i] != sticking)
            continue;
          const double x = std::pow(points["x [mm]"][i] - centre, 2);
          const double y = std::pow(mu * p - q, 2);
          n += 1.;
          X += x;
          Y += y;
          XX += x * x;
          XY += x * y;
        }
      EXPECT_GT(n, 10.);
      const double slope = (n * XY - X * Y) / (n * XX - X * X);
      return std::sqrt(-(Y - slope * X) / n / slope);
    }

    class CattaneoMindlin : public Multipliers
    {};
  } // namespace

  TEST_P(CattaneoMindlin, sticks_in_the_middle_within_three_percent)
  {
    for (const char *push : {"0.03", "0.05"})
      {
        SCOPED_TRACE(push);
        const SceneRun result =
          run("cattaneo-mindlin.prm",
              {std::string("Supports/motion x=") + push + "*max(t-1, 0)"});
        EXPECT_EQ(result.status(), "completed");
        const Forces force = sum(result.interface);
        const double load  = force.Q / (mu * force.P);
        EXPECT_GT(load, .2);
        EXPECT_LT(load, .9);
        const double a     = hertz(force.P).half_width;
        const double exact = a * std::sqrt(1. - load);
        const double found = stick_half_width(result.interface, force.centre);
        record("Q over mu P", load);
        record("stick half-width over closed form", found / exact);
        EXPECT_NEAR(found, exact, .03 * exact);
      }
  }

  INSTANTIATE_TEST_SUITE_P(Mortar,
                           CattaneoMindlin,
                           testing::Values("standard", "dual"));
} // namespace demold

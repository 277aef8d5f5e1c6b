// SPDX-License-Identifier: LGPL-2.1-or-later
// jkr.prm: a sphere is pulled off (Johnson, Kendall and Roberts
// 1971; theory E.7), and which strategy comes how far.
#include "step-arclength/circular_front.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double R = 10.; // [mm]
    constexpr double w = .5 * .4 * .002;

    /// A point in the units of Maugis: K = 4 E*/3; a in (pi w R^2/K)^(1/3),
    /// delta (positive: pressed) in (pi^2 w^2 R/K^2)^(1/3), F (positive:
    /// pressed) in pi w R.
    struct Point
    {
      double a, F, delta;
      bool   envelope = false; ///< does a machine come here?
    };

    Point on_curve(const double a)
    {
      return {a,
              a * a * a - std::sqrt(6. * a * a * a),
              a * a - std::sqrt(8. * a / 3.)};
    }

    const Point load_limit = on_curve(std::cbrt(1.5));
    const Point grip_limit = on_curve(std::cbrt(1. / 6.));

    /// Points with a bond, and where they are on the curve by their radius.
    std::vector<Point> points(const SceneRun &run)
    {
      const double       K = 4. / 3. * reduced_modulus;
      std::vector<Point> list;
      for (const FrontRow &row : front_rows(run, w))
        if (row.bonded)
          list.push_back({row.a / std::cbrt(pi * w * R * R / K),
                          -row.F / (pi * w * R),
                          -row.u / std::cbrt(pi * pi * w * w * R / (K * K)),
                          row.envelope});
      return list;
    }

    Point lowest(const std::vector<Point> &list, double Point::*value)
    {
      return *std::min_element(list.begin(),
                               list.end(),
                               [&](const Point &p, const Point &q) {
                                 return p.*value < q.*value;
                               });
    }

    /// Force at the turning point of the approach: vertex of the parabola
    /// through the lowest point and those beside it.
    double force_at_turn(const std::vector<Point> &list)
    {
      std::size_t i = 1;
      for (std::size_t k = 1; k + 1 < list.size(); ++k)
        if (list[k].delta < list[i].delta)
          i = k;
      const Point &p = list[i - 1], &q = list[i], &r = list[i + 1];
      const double s = (q.delta - p.delta) / (q.F - p.F),
                   t = (r.delta - q.delta) / (r.F - q.F);
      return .5 * (p.F + q.F) - s * .5 * (r.F - p.F) / (t - s);
    }

    /// Where a load or a grip jumps.
    Point last_of_a_machine(const std::vector<Point> &list)
    {
      Point last = list.front();
      for (const Point &p : list)
        if (p.envelope)
          last = p;
      return last;
    }

    constexpr double part = .05;
  } // namespace

  TEST(Jkr, closed_form_has_the_values_of_the_literature)
  {
    EXPECT_NEAR(load_limit.F, -1.5, 1e-12);
    EXPECT_NEAR(load_limit.delta, -.43679, 1e-5);
    EXPECT_NEAR(grip_limit.F, -5. / 6., 1e-12);
    EXPECT_NEAR(grip_limit.delta, -.90856, 1e-5);
  }

  /// Pressed less than the scene, and less to wait for: from above the first
  /// limit on.
  TEST(Jkr, path_follows_the_closed_form_through_both_limits)
  {
    const std::string motion = "if(t < 1, -0.0125*t, 0.0225*t - 0.035)";
    const SceneRun    run    = run_arclength("jkr.prm",
                                       {"Body/fine width=0.37",
                                              "Supports/motion y=" + motion,
                                              "Process/opening=" + motion});
    EXPECT_EQ(run.exit_code, 0);
    const auto list = points(run);
    record("lowest force", lowest(list, &Point::F).F);
    record("lowest approach", lowest(list, &Point::delta).delta);
    record("force there", force_at_turn(list));
    EXPECT_NEAR(lowest(list, &Point::F).F, -1.5, part * 1.5);
    EXPECT_NEAR(lowest(list, &Point::delta).delta,
                grip_limit.delta,
                -part * grip_limit.delta);
    EXPECT_NEAR(force_at_turn(list), grip_limit.F, -part * grip_limit.F);
    EXPECT_NEAR(last_of_a_machine(list).a, grip_limit.a, part);

    const double largest = list.front().a;
    double       worst_F = 0., worst_delta = 0.;
    unsigned int beyond = 0;
    for (const Point &p : list)
      if (p.a < .97 * largest)
        {
          const Point exact = on_curve(p.a);
          worst_F           = std::max(worst_F, std::abs(p.F - exact.F));
          worst_delta = std::max(worst_delta, std::abs(p.delta - exact.delta));
          beyond += p.a < .9 * grip_limit.a ? 1 : 0;
        }
    record("largest deviation of the force", worst_F);
    record("largest deviation of the approach", worst_delta);
    EXPECT_LT(worst_F, part * 1.5);
    EXPECT_LT(worst_delta, -part * grip_limit.delta);
    EXPECT_GE(beyond, 10u);
    EXPECT_LT(lowest(list, &Point::a).a, .2 * grip_limit.a);
  }

  /// No equilibrium carries more: the run ends with exit code 1.
  TEST(Jkr, load_is_carried_up_to_its_limit_and_no_further)
  {
    const SceneRun run = run_arclength("jkr-load.prm");
    EXPECT_EQ(run.exit_code, 1);
    const auto list = points(run);
    record("lowest force", lowest(list, &Point::F).F);
    record("smallest radius", lowest(list, &Point::a).a);
    EXPECT_NEAR(lowest(list, &Point::F).F, -1.5, part * 1.5);
    EXPECT_NEAR(lowest(list, &Point::a).a, load_limit.a, part * load_limit.a);
  }

  /// Viscous damage takes the small jumps of node after node, not the large
  /// one.
  TEST(Jkr, grip_passes_the_limit_of_a_load_and_ends_at_its_own)
  {
    const SceneRun run = run_arclength("jkr-grip.prm");
    EXPECT_EQ(run.exit_code, 0);
    const auto list = points(run);
    record("lowest force", lowest(list, &Point::F).F);
    EXPECT_NEAR(lowest(list, &Point::F).F, -1.5, part * 1.5);
    const auto at_limit =
      std::find_if(list.begin(), list.end(), [](const Point &p) {
        return p.F < 0. && p.a < grip_limit.a;
      });
    ASSERT_NE(at_limit, list.end());
    record("force at the limit of a grip", at_limit->F);
    record("approach there", at_limit->delta);
    EXPECT_NEAR(at_limit->F, grip_limit.F, -part * grip_limit.F);
    EXPECT_NEAR(at_limit->delta, grip_limit.delta, -part * grip_limit.delta);

    // The branch behind goes back to an approach of 0; this one does not.
    record("approach at the end", list.back().delta);
    EXPECT_LT(list.back().a, .1 * grip_limit.a);
    for (auto p = at_limit; p != list.end(); ++p)
      EXPECT_LT(p->delta, (1. - part) * grip_limit.delta);
    EXPECT_GT(list.back().delta, 1.1 * grip_limit.delta);
  }
} // namespace demold

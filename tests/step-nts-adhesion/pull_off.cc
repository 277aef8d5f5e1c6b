// SPDX-License-Identifier: LGPL-2.1-or-later
// pull-off.prm: a confined column in series with its bond.
#include "step-nts-adhesion/run_nts.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double area = 2.; // [mm^2]

    struct Column
    {
      double height;
      Bond   bond;
      Rubber rubber;

      double opening(const double gap) const
      {
        return gap +
               height * (rubber.confined_stretch(bond.traction(gap)) - 1.);
      }

      /// Nominal stress at an opening, where the opening grows with the gap.
      double stress(const double u) const
      {
        if (u >= bond.rupture)
          return 0.;
        return bond.traction(
          root_of([&](double g) { return opening(g) - u; }, 0., bond.rupture));
      }

      double peak_opening() const
      {
        return opening(bond.onset());
      }

      /// Largest deviation [N] of the force of a run with @p area [mm^2].
      double deviation(const SceneRun &run, const double area) const
      {
        const auto &force = run.history["force [N]"];
        const auto &u     = run.history["opening [mm]"];
        double      worst = 0.;
        for (std::size_t i = 0; i < force.size(); ++i)
          worst = std::max(worst, std::abs(force[i] - area * stress(u[i])));
        return worst;
      }

      /// Energy [mJ/mm^2] at the peak, less what the bond needs.
      double excess() const
      {
        const double stretch = rubber.confined_stretch(bond.strength);
        return height *
                 integral_of([&](double l) { return rubber.confined(l); },
                             1.,
                             stretch) +
               bond.work(bond.onset()) - bond.fracture_energy();
      }

      std::vector<std::string> overrides() const
      {
        const auto text = [](double x) { return std::to_string(x); };
        return {"Adhesion/strength=" + text(bond.strength),
                "Adhesion/rupture gap=" + text(bond.rupture),
                "Adhesion/penalty=" + text(bond.penalty),
                "Body/size=2, " + text(height),
                "Body/cells=2, " + text(height),
                "Pull/opening=" + text(1.5 * bond.rupture + .15)};
      }
    };

    // Softens faster than a column of 40 mm gives way: 2.22 > 1.27 MPa/mm.
    const Column long_column{40., {.2, .1, 20.}, {}};

    class StableColumn : public testing::TestWithParam<Bond>
    {};
  } // namespace

  TEST(Column, closed_form_has_the_confined_stress_of_theory_A1)
  {
    EXPECT_NEAR(Rubber().confined(1.01), .50946535, 1e-8);
    EXPECT_NEAR(Rubber().confined(1.05), 2.49904762, 1e-8);
  }

  TEST_P(StableColumn, follows_the_closed_form_all_the_way)
  {
    const Column   column{8., GetParam(), {}};
    const SceneRun run = run_nts("pull-off.prm", column.overrides());
    EXPECT_EQ(run.status(), "completed");
    ASSERT_GT(run.history.n_rows(), 80u);
    const double peak  = area * column.bond.strength;
    const double worst = column.deviation(run, area);
    EXPECT_LT(worst, 1e-3 * peak);
    record("largest deviation over peak", worst / peak);

    const double lost = area * column.bond.fracture_energy();
    EXPECT_NEAR(run.number("work of demolding [mJ]"), lost, 1e-3 * lost);
    EXPECT_NEAR(run.number("adhesion dissipation [mJ]"), lost, 1e-6 * lost);
    EXPECT_LT(run.number("energy balance error [-]"), 1e-3);
    EXPECT_EQ(run.number("bonded area left [mm^2]"), 0.);
  }

  INSTANTIATE_TEST_SUITE_P(bonds,
                           StableColumn,
                           testing::Values(Bond{.2, .1, 20.},
                                           Bond{.05, .2, 20.},
                                           Bond{.5, .4, 20.},
                                           Bond{1., .3, 100.}));

  // The state is uniform, so that nothing is left but the solver's tolerance,
  // if the areas of the points are what the elements call uniform.
  TEST(QuadraticColumn, follows_the_closed_form_in_every_dimension)
  {
    struct Shape
    {
      double                   area; ///< [mm^2]
      std::vector<std::string> overrides;
    };
    const Column column{8., Bond(), {}};
    for (const Shape &shape :
         {Shape{2., {}},
          Shape{4. * std::acos(-1.), {"dimension=axisymmetric"}},
          Shape{2.,
                {"dimension=3",
                 "Body/lower corner=0, 0, 0",
                 "Body/size=2, 1, 8",
                 "Body/cells=2, 1, 2",
                 "Mould/from=-1, -1",
                 "Mould/to=3, 2",
                 "Mould/facets=3, 3",
                 "Supports/held=top xyz, left x, right x, front y, back y"}}})
      {
        auto overrides = shape.overrides;
        overrides.insert(overrides.end(),
                         {"element=q2",
                          "Pull/opening=0.12",
                          "Solution/largest increment=0.01"});
        const SceneRun run = run_nts("pull-off.prm", overrides);
        SCOPED_TRACE(testing::PrintToString(overrides));
        EXPECT_EQ(run.status(), "completed");
        ASSERT_GE(run.history.n_rows(), 12u);
        const double peak = shape.area * column.bond.strength;
        EXPECT_LT(column.deviation(run, shape.area), 1e-6 * peak);
        EXPECT_GT(run.number("peak force [N]"), .95 * peak);
      }
  }

  TEST(LongColumn,
       jumps_in_quasi_statics_and_releases_what_the_bond_does_not_need)
  {
    // Newton may find the unstable branch, which softens below the peak, up to
    // about an increment too early: small increments.
    auto overrides = long_column.overrides();
    overrides.emplace_back("Solution/largest increment=0.0005");
    const SceneRun run = run_nts("pull-off.prm", overrides);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.status(), "completed with jumps");
    EXPECT_EQ(run.number("jumps"), 1.);
    const double strength = area * long_column.bond.strength;
    EXPECT_NEAR(run.number("peak force [N]"), strength, 1e-3 * strength);
    EXPECT_NEAR(run.number("opening at peak [mm]"),
                long_column.peak_opening(),
                1e-3 * long_column.peak_opening());
    const double released = area * long_column.excess();
    EXPECT_NEAR(run.number("released energy [mJ]"), released, .02 * released);
    EXPECT_LT(run.number("energy balance error [-]"), 1e-3);
  }

  TEST(LongColumn, turns_the_released_energy_into_vibration_in_dynamics)
  {
    // Slowly: the mould goes on pulling while the jump builds up.
    auto overrides = long_column.overrides();
    for (const char *entry : {"Solution/strategy=dynamics",
                              "Material/density=1.1e-9",
                              "Pull/velocity=0.2"})
      overrides.emplace_back(entry);
    const SceneRun run = run_nts("pull-off.prm", overrides);
    EXPECT_EQ(run.status(), "completed");
    const double lost     = area * long_column.bond.fracture_energy();
    const double released = area * long_column.excess();
    EXPECT_NEAR(run.number("adhesion dissipation [mJ]"), lost, 1e-6 * lost);
    EXPECT_NEAR(run.number("work of demolding [mJ]") - lost,
                released,
                .02 * released);
    EXPECT_LT(run.number("energy balance error [-]"), 5e-3);

    // Every entry by its own formula, in the rows behind the jump.
    const std::size_t last = run.history.n_rows() - 1;
    double            kept = 0.;
    for (const char *entry : {"kinetic energy [mJ]",
                              "stored energy [mJ]",
                              "algorithmic dissipation [mJ]",
                              "impact dissipation [mJ]"})
      kept += run.history[entry][last];
    EXPECT_NEAR(kept, released, .02 * released);
  }

  TEST(LongColumn, is_left_to_dynamics_by_automatic_where_it_jumps)
  {
    auto overrides = long_column.overrides();
    for (const char *entry : {"Solution/strategy=automatic",
                              "Material/density=1.1e-9",
                              "Pull/velocity=0.2"})
      overrides.emplace_back(entry);
    const SceneRun run = run_nts("pull-off.prm", overrides);
    EXPECT_EQ(run.status(), "completed");
    const double strength = area * long_column.bond.strength;
    EXPECT_NEAR(run.number("peak force [N]"), strength, 1e-3 * strength);
    const double lost     = area * long_column.bond.fracture_energy();
    const double released = area * long_column.excess();
    EXPECT_NEAR(run.number("work of demolding [mJ]") - lost,
                released,
                .02 * released);
    EXPECT_LT(run.number("energy balance error [-]"), 5e-3);

    // No inertia before the peak: nothing kinetic, nothing algorithmic.
    const auto &opening = run.history["opening [mm]"];
    const auto &kinetic = run.history["kinetic energy [mJ]"];
    double      moving  = 0.;
    for (std::size_t i = 0; i < opening.size(); ++i)
      if (opening[i] < .99 * long_column.peak_opening())
        EXPECT_EQ(kinetic[i], 0.);
      else
        moving = std::max(moving, kinetic[i]);
    EXPECT_GT(moving, .1 * released);
  }

  TEST(Column, is_quasi_static_all_the_way_by_automatic)
  {
    const Column column{8., {.2, .1, 20.}, {}};
    auto         overrides = column.overrides();
    overrides.emplace_back("Material/density=1.1e-9");
    const SceneRun quasi_static = run_nts("pull-off.prm", overrides);
    overrides.emplace_back("Solution/strategy=automatic");
    const SceneRun automatic = run_nts("pull-off.prm", overrides);
    EXPECT_EQ(automatic.number("share of increments with inertia [-]"), 0.);
    EXPECT_EQ(automatic.number("newton iterations"),
              quasi_static.number("newton iterations"));
    EXPECT_EQ(automatic.number("work of demolding [mJ]"),
              quasi_static.number("work of demolding [mJ]"));
  }

  TEST(LongColumn,
       excess_is_that_of_a_linear_spring_in_series_but_for_a_percent)
  {
    const double linear =
      .5 * long_column.bond.strength *
      (long_column.peak_opening() - long_column.bond.rupture);
    EXPECT_NEAR(long_column.excess(), linear, .01 * linear);
  }
} // namespace demold

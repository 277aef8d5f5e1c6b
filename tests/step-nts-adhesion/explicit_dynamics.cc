// SPDX-License-Identifier: LGPL-2.1-or-later
// Explicit dynamics of a confined column: waves, the critical step, and what
// happens above it.
#include "step-nts-adhesion/run_nts.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double       height = 40., density = 1.1e-9; // [mm], [t/mm^3]
    constexpr unsigned int n_cells = 40;
    constexpr double       load    = 1e-3; // [MPa], small strains

    /// Speed [mm/s] of pressure waves, sqrt(dP/dl / rho) at stretch 1.
    double wave_speed()
    {
      const double step = 1e-5;
      return std::sqrt(
        (Rubber().confined(1. + step) - Rubber().confined(1. - step)) /
        (2. * step) / density);
    }

    /// Critical step [s] of a chain of equal linear elements with lumped
    /// masses, held at one end: 2/omega of its highest frequency
    /// omega = 2 c/h cos(pi/(4 n)).
    double chain_critical_step()
    {
      return height / n_cells / wave_speed() /
             std::cos(std::acos(-1.) / (4. * n_cells));
    }

    /// The column hangs from its top and is loaded at once at its bottom.
    std::vector<std::string> loaded(const double end, const double interval)
    {
      return {"Contact/formulation=none",
              "Adhesion/law=none",
              "Body/size=2, 40",
              "Body/cells=1, 40",
              "Material/density=1.1e-9",
              "Supports/held=left x, right x",
              "Supports/driven=top xy",
              "Supports/traction boundary=bottom",
              "Supports/traction=0, -" + std::to_string(load) + ", 0",
              "Process/moved by=grip",
              "Process/end time=" + std::to_string(end * 1e6) + "e-6",
              "Process/opening=t",
              "Process/direction=0, 1, 0",
              "Process/force on=top",
              "Solution/strategy=explicit dynamics",
              "Solution/largest increment=" + std::to_string(interval * 1e6) +
                "e-6"};
    }

    /// The first critical step [s] among the events of a run.
    double critical_step_of(const SceneRun &run)
    {
      const auto        events = run.summary.at("events").get<std::string>();
      const std::string words  = "critical step ";
      return std::stod(events.substr(events.find(words) + words.size()));
    }
  } // namespace

  TEST(ExplicitBar, swings_with_the_period_of_its_waves)
  {
    const double   transit = height / wave_speed();
    const SceneRun run =
      run_nts("pull-off.prm", loaded(24. * transit, .02 * transit));
    EXPECT_EQ(run.status(), "completed");
    // The force at the top changes between 0 and twice the load as the front
    // arrives, first after one transit and then after every second one.
    const auto         &F    = run.history["force [N]"];
    const auto         &time = run.history["time [s]"];
    const double        half = 2. * load; // on 2 mm^2
    std::vector<double> crossings;
    for (std::size_t i = 1; i < F.size(); ++i)
      if ((F[i - 1] - half) * (F[i] - half) <= 0. &&
          (crossings.empty() || time[i] - crossings.back() > transit))
        crossings.push_back(time[i - 1] + (time[i] - time[i - 1]) *
                                            (half - F[i - 1]) /
                                            (F[i] - F[i - 1]));
    ASSERT_EQ(crossings.size(), 12u);
    EXPECT_NEAR(crossings.front(), transit, .03 * transit);
    EXPECT_NEAR((crossings.back() - crossings.front()) / 11.,
                2. * transit,
                2e-3 * 2. * transit);
    EXPECT_LT(run.number("energy balance error [-]"), 1e-3);
  }

  TEST(ExplicitBar, steps_by_the_critical_step_of_its_chain)
  {
    const double   dt  = chain_critical_step();
    const SceneRun run = run_nts("pull-off.prm", loaded(900. * dt, 9. * dt));
    EXPECT_NEAR(critical_step_of(run), dt, 1e-3 * dt);
    EXPECT_NEAR(run.number("increments"), 1000., 1.); // numbers are rounded
    EXPECT_EQ(run.history.n_rows(), 100u);

    auto scaled = loaded(900. * dt, 9. * dt);
    scaled.emplace_back("Solution/mass scaling=4");
    EXPECT_NEAR(critical_step_of(run_nts("pull-off.prm", scaled)),
                2. * dt,
                1e-3 * 2. * dt);
  }

  TEST(ExplicitBar, stays_bounded_below_the_critical_step_and_gives_up_above)
  {
    const double dt    = chain_critical_step();
    auto         below = loaded(20000. * dt, 200. * dt);
    auto         above = below;
    below.emplace_back("Solution/safety factor=0.95");
    above.emplace_back("Solution/safety factor=1.05");
    const SceneRun bounded = run_nts("pull-off.prm", below);
    EXPECT_EQ(bounded.status(), "completed");
    // Fronts of square waves overshoot by less than a fifth of their height.
    EXPECT_LT(bounded.number("peak force [N]"), 1.2 * 2. * 2. * load);

    const SceneRun grown = run_nts("pull-off.prm", above);
    EXPECT_EQ(grown.exit_code, 1);
    EXPECT_EQ(grown.status(), "gave up");
    const auto reason = grown.summary.at("reason").get<std::string>();
    for (const char *words :
         {"explicit dynamics", "critical", "Solution/safety factor"})
      EXPECT_NE(reason.find(words), std::string::npos) << reason;
  }

  TEST(ExplicitBar, finds_the_shorter_step_of_a_stiff_contact_as_it_closes)
  {
    // Lowered by 0.06 mm onto a mould 0.01 mm below it, whose penalty is some
    // forty times as stiff as an element.
    constexpr double length = 20., gap = .01, travel = .06; // [mm]
    const SceneRun   run = run_nts("pull-off.prm",
                                 {"Adhesion/law=none",
                                    "Contact/penalty=2000",
                                    "Body/lower corner=0, 0.01",
                                    "Body/size=2, 20",
                                    "Body/cells=1, 10",
                                    "Material/density=1.1e-9",
                                    "Supports/held=left x, right x",
                                    "Supports/driven=top xy",
                                    "Supports/motion y=-t",
                                    "Process/moved by=grip",
                                    "Process/end time=0.06",
                                    "Process/opening=t",
                                    "Process/direction=0, -1, 0",
                                    "Process/force on=top",
                                    "Solution/strategy=explicit dynamics"});
    ASSERT_EQ(run.status(), "completed");
    EXPECT_LT(run.number("energy balance error [-]"), .01);
    const auto events = run.summary.at("events").get<std::string>();
    EXPECT_NE(events.find("critical step", events.find("critical step") + 1),
              std::string::npos)
      << events;
    // In series with the penalty; waves of one velocity step are 0.5 % of it.
    const double pressure = root_of(
      [&](const double p) {
        return length * (1. - Rubber().confined_stretch(-p)) + p / 2000. -
               (travel - gap);
      },
      0.,
      1.);
    EXPECT_NEAR(run.number("force at end [N]"),
                2. * pressure,
                .02 * 2. * pressure);
  }

  namespace
  {
    /// A block pressed and rubbed on a deformable one, coarse, 3-D.
    SceneRun press(const std::string &strategy, const std::string &mass_scaling)
    {
      return run_nts("press.prm",
                     {"Body/cells=3, 3, 3",
                      "Base/cells=4, 4, 2",
                      "Friction/coefficient=0.2",
                      "Solution/first increment=0.02",
                      "Solution/largest increment=0.02",
                      "Solution/strategy=" + strategy,
                      "Solution/mass scaling=" + mass_scaling});
    }
  } // namespace

  TEST(ExplicitPress, does_the_work_of_quasi_statics_on_two_bodies)
  {
    const SceneRun run    = press("explicit dynamics", "1e5");
    const SceneRun slowly = press("quasi-static", "1");
    ASSERT_EQ(run.status(), "completed");
    ASSERT_EQ(slowly.status(), "completed");
    const double work = slowly.number("work of demolding [mJ]");
    EXPECT_NEAR(run.number("work of demolding [mJ]"), work, .01 * work);
    EXPECT_LT(run.number("energy balance error [-]"), .01);
    const auto events = run.summary.at("events").get<std::string>();
    EXPECT_EQ(events.find("WARNING"), std::string::npos) << events;
  }

  TEST(ExplicitPress, warns_where_steps_are_so_long_that_contact_brings_energy)
  {
    const SceneRun run = press("explicit dynamics", "1e6");
    EXPECT_LT(run.number("impact dissipation [mJ]"),
              -.01 * run.number("work of demolding [mJ]"));
    const auto events = run.summary.at("events").get<std::string>();
    EXPECT_NE(events.find("WARNING: contact has brought"), std::string::npos)
      << events;
  }
} // namespace demold

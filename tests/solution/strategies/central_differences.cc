// SPDX-License-Identifier: LGPL-2.1-or-later
// Explicit dynamics of one mass and one spring, against the closed form of
// central differences, which swing at 2/dt asin(omega dt/2) up to dt = 2/omega.
#include "solution/central_differences.h"

#include "solution/critical_step.h"
#include "solution/explicit_dynamics.h"
#include "solution/explicit_parameters.h"

#include "solution/strategies/spring.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace demold;

namespace
{
  const double critical = 2. / omega; // [s]
  const double period   = 2. * dealii::numbers::PI / omega;

  const OnAccept go_on = [](const IncrementRecord &) { return true; };

  class Mass
  {
  public:
    explicit Mass(const double stop = 1e6)
      : form(pulled_spring(stop))
      , motion(static_cast<CentralDifferences &>(form->add(
          std::make_unique<CentralDifferences>(spring_masses(*form)))))
    {}

    /// Up to @p end [s] with a record after every @p interval [s].
    StrategyResult run(const double    end,
                       const double    interval,
                       const OnAccept &on_accept)
    {
      IncrementParameters increments;
      increments.largest = interval;
      increments.state   = &state;
      return run_explicit_dynamics(
        *form,
        {motion, parameters, seconds, 1., [](const std::string &) {}},
        increments,
        end,
        on_accept);
    }

    double place() const
    {
      return form->accepted(0);
    }

    std::unique_ptr<WeakForm> form;
    CentralDifferences       &motion;
    ExplicitParameters        parameters;
    IncrementState            state;
    double                    seconds = 0.;
  };

  /// Where central differences are after @p n steps of @p dt behind a support
  /// of constant velocity: the first step goes nowhere, as at rest.
  double closed_place(const unsigned int n, const double dt)
  {
    const double angle = 2. * std::asin(.5 * omega * dt);
    return pull * dt * (n - std::sin(n * angle) / std::sin(angle));
  }
} // namespace

TEST(CriticalStep, is_two_over_omega_of_one_mass)
{
  Mass mass;
  EXPECT_NEAR(critical_step(*mass.form, mass.motion.masses(), 1e-9),
              critical,
              1e-12 * critical);
}

TEST(CentralDifferences, follow_their_closed_form)
{
  for (const double share : {.1, .5, .9})
    {
      Mass         mass;
      const double dt   = share * critical;
      unsigned int n    = 0;
      double       last = 0.;
      mass.run(200.5 * dt, dt, [&](const IncrementRecord &record) {
        EXPECT_EQ(record.steps, 1u);
        ++n;
        if (n <= 200) // the last step is half as long
          {
            EXPECT_NEAR(mass.place(),
                        closed_place(n, dt),
                        1e-9 * pull * n * dt);
          }
        last = record.time;
        return true;
      });
      EXPECT_EQ(n, 201u);
      EXPECT_NEAR(last, 200.5 * dt, 1e-9 * last);
    }
}

TEST(CentralDifferences, converge_with_order_two_in_place_and_velocity)
{
  // x = v (t - sin(w t)/w)
  const double end    = 1.3 * period;
  const double x      = pull * (end - std::sin(omega * end) / omega);
  const double x_dot  = pull * (1. - std::cos(omega * end));
  double       last_x = 0., last_x_dot = 0.;
  for (const unsigned int n : {80u, 160u, 320u})
    {
      Mass mass;
      EXPECT_EQ(mass.run(end, end / n, go_on).increments, n);
      const double error_x     = std::abs(mass.place() - x);
      const double error_x_dot = std::abs(mass.motion.velocity()(0) - x_dot);
      if (n > 80)
        {
          EXPECT_NEAR(std::log2(last_x / error_x), 2., .1);
          EXPECT_NEAR(std::log2(last_x_dot / error_x_dot), 2., .1);
        }
      last_x     = error_x;
      last_x_dot = error_x_dot;
    }
}

TEST(CentralDifferences, lend_energy_and_take_it_back_in_a_closed_ledger)
{
  // Of a swing of energy E the integrator holds up to (omega dt/2)^2 E.
  constexpr double share = .45;
  Mass             mass(.3 * period);
  const double     dt  = share * critical;
  double           gap = 0., largest = 0., least = 1e300, most = -1e300;
  double           held_least = 1e300, held_most = -1e300;
  mass.run(50. * period, dt, [&](const IncrementRecord &record) {
    const Energies e = mass.form->energies();
    gap              = std::max(gap, std::abs(e.gap()));
    if (record.time > .3 * period + dt) // free from here
      {
        const double energy = e.stored + e.kinetic;
        largest             = std::max(largest, energy);
        least               = std::min(least, energy + e.algorithmic);
        most                = std::max(most, energy + e.algorithmic);
        held_least          = std::min(held_least, e.algorithmic);
        held_most           = std::max(held_most, e.algorithmic);
      }
    return true;
  });
  EXPECT_LT(gap, 1e-11 * largest);
  EXPECT_LT(most - least, 1e-11 * largest);
  EXPECT_LE(held_most - held_least, share * share * largest * (1. + 1e-9));
  EXPECT_GE(held_most - held_least, .95 * share * share * largest);
}

TEST(CentralDifferences, stay_bounded_below_the_critical_step)
{
  Mass mass;
  mass.parameters.safety = .95;
  const double dt        = .95 * critical;
  const double angle     = 2. * std::asin(.95);
  const double bound     = pull * dt / std::sin(angle);
  double       largest   = 0.;
  const auto   result =
    mass.run(2e4 * dt, 100. * dt, [&](const IncrementRecord &record) {
      largest = std::max(largest, std::abs(mass.place() - pull * record.time));
      EXPECT_EQ(record.steps, 100u);
      return true;
    });
  EXPECT_FALSE(result.gave_up) << result.reason;
  EXPECT_EQ(result.increments, 20000u);
  EXPECT_LE(largest, (1. + 1e-6) * bound);
  EXPECT_GE(largest, .9 * bound);
}

TEST(CentralDifferences, grow_above_it_until_the_run_gives_up_and_says_why)
{
  Mass mass;
  mass.parameters.safety = 1.05;
  const double dt        = 1.05 * critical;
  const auto   result    = mass.run(2e4 * dt, 100. * dt, go_on);
  EXPECT_TRUE(result.gave_up);
  for (const char *words : {"step ",
                            "the critical one",
                            "kinetic energy",
                            "Solution/safety factor than 1.05",
                            "unstable"})
    EXPECT_NE(result.reason.find(words), std::string::npos) << result.reason;
}

TEST(ExplicitDynamics, goes_on_bitwise_from_a_checkpoint)
{
  const double dt  = .9 * critical;
  const double end = 500. * dt;
  Mass         whole;
  whole.run(end, 50. * dt, go_on);

  Mass         half;
  unsigned int n = 0;
  half.run(end, 50. * dt, [&n](const IncrementRecord &) { return ++n < 5; });
  std::stringstream checkpoint;
  half.form->save(checkpoint);

  Mass again;
  again.form->load(checkpoint);
  again.state              = half.state;
  const auto        result = again.run(end, 50. * dt, go_on);
  std::stringstream one, two;
  whole.form->save(one);
  again.form->save(two);
  EXPECT_EQ(one.str(), two.str());
  EXPECT_EQ(result.increments, 250u);
  EXPECT_EQ(again.state.path, whole.state.path);
}

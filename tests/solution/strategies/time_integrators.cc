// SPDX-License-Identifier: LGPL-2.1-or-later
// The time integrators on one mass and one spring, against the closed form.
#include "solution/dynamics.h"
#include "solution/inertia.h"
#include "solution/linear_solver.h"
#include "solution/newton.h"

#include "solution/strategies/spring.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace demold;

namespace
{
  /// At rest until the support is pulled with constant velocity; the support
  /// stops at @p stop [s].
  class Oscillator
  {
  public:
    Oscillator(const TimeIntegrator &integrator, const double stop)
      : integrator(integrator)
      , solver(LinearSolverParameters(), MPI_COMM_SELF)
      , newton(parameters(), solver)
    {
      form    = pulled_spring(stop);
      inertia = static_cast<Inertia *>(&form->add(
        std::make_unique<Inertia>(spring_masses(*form), integrator, 1e6)));
    }

    void run(const double end, const unsigned int n, const OnAccept &on_accept)
    {
      IncrementParameters increments;
      increments.first = increments.largest = end / n;
      increments.smallest                   = 1e-6 * end / n;
      increments.growth                     = 1.;
      const auto result                     = run_dynamics(*form,
                                       newton,
                                       *inertia,
                                       integrator,
                                       increments,
                                       end,
                                       on_accept);
      ASSERT_FALSE(result.gave_up) << result.reason;
      ASSERT_EQ(result.increments, n);
    }

    static NewtonParameters parameters()
    {
      NewtonParameters result;
      result.residual_tolerance = 1e-13;
      return result;
    }

    const TimeIntegrator      integrator;
    LinearSolver              solver;
    Newton                    newton;
    std::unique_ptr<WeakForm> form;
    Inertia                  *inertia;
  };

  TimeIntegrator integrator(const std::string &scheme)
  {
    TimeIntegrator result;
    result.scheme = scheme;
    return result;
  }

  const std::vector<std::string> schemes = {"bossak",
                                            "newmark",
                                            "hht",
                                            "generalised-alpha"};

  const OnAccept go_on = [](const IncrementRecord &) { return true; };
} // namespace

TEST(TimeIntegrators, converge_with_order_two_in_place_and_velocity)
{
  // x = v (t - sin(w t)/w) while the support moves
  const double end   = 1.3 * 2. * dealii::numbers::PI / omega;
  const double x     = pull * (end - std::sin(omega * end) / omega);
  const double x_dot = pull * (1. - std::cos(omega * end));
  for (const std::string &scheme : schemes)
    {
      SCOPED_TRACE(scheme);
      double last_x = 0., last_x_dot = 0.;
      for (const unsigned int n : {80u, 160u, 320u})
        {
          Oscillator oscillator(integrator(scheme), 1e6);
          oscillator.run(end, n, go_on);
          const double error_x = std::abs(oscillator.form->accepted(0) - x);
          const double error_x_dot =
            std::abs(oscillator.inertia->velocity()(0) - x_dot);
          if (n > 80)
            {
              EXPECT_NEAR(std::log2(last_x / error_x), 2., .1);
              EXPECT_NEAR(std::log2(last_x_dot / error_x_dot), 2., .1);
            }
          last_x     = error_x;
          last_x_dot = error_x_dot;
        }
    }
}

TEST(TimeIntegrators, close_the_ledger_and_only_newmark_keeps_all_energy)
{
  const double period = 2. * dealii::numbers::PI / omega;
  const double stop   = .3 * period;
  for (const std::string &scheme : schemes)
    {
      SCOPED_TRACE(scheme);
      Oscillator oscillator(integrator(scheme), stop);
      double     gap = 0., largest = 0., first = 0., last = 0., lost = 0.;
      oscillator.run(5. * period, 100, [&](const IncrementRecord &record) {
        const Energies e = oscillator.form->energies();
        gap              = std::max(gap, std::abs(e.gap()));
        last             = e.stored + e.kinetic;
        largest          = std::max(largest, last);
        lost             = e.algorithmic;
        if (record.time < stop + 1e-9 * period) // free from here
          first = last;
        return true;
      });
      EXPECT_LT(gap, 1e-12 * largest);
      if (scheme == "newmark")
        {
          EXPECT_NEAR(last, first, 1e-11 * first);
          EXPECT_NEAR(lost, 0., 1e-11 * first);
        }
      else
        {
          EXPECT_LT(last, .999 * first);
          EXPECT_GT(lost, 0.);
        }
    }
}

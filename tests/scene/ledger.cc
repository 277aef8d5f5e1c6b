// SPDX-License-Identifier: LGPL-2.1-or-later
// The ledger sees a wrong entry: five per cent too much of one dissipation is
// a gap of five per cent of it.
#include "scene/recorder.h"
#include "scratch_folder.h"
#include "weak_form/energies.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace demold;

namespace
{
  constexpr unsigned int first_dissipation = 3; ///< in Energies::as_array()

  /// Closed books at a time between 0 and 1: all entries differ, and the
  /// external work is their sum.
  std::array<double, Energies::n_entries> closed_books(const double time)
  {
    std::array<double, Energies::n_entries> e{};
    for (unsigned int i = 1; i < e.size(); ++i)
      {
        e[i] = i < first_dissipation ? i * time * (1. - time) : i * time;
        e[0] += e[i];
      }
    return e;
  }

  /// Lets a recorder see 20 increments, with one entry multiplied by
  /// @p factor, and asks it for its energy balance error.
  double balance_error(const unsigned int entry,
                       const double       factor,
                       const std::string &strategy)
  {
    ScratchFolder folder;
    RunContext    context;
    context.output_folder = folder.path.string();
    context.quiet         = true;
    Recorder recorder(context, true, false);
    for (unsigned int k = 0; k <= 20; ++k)
      {
        auto e = closed_books(k / 20.);
        e[entry] *= factor;
        Observation now;
        now.time     = k / 20.;
        now.opening  = now.time;
        now.energies = Energies::from_array(e);
        now.strategy = strategy;
        recorder.record(now);
      }
    return recorder.energy_balance_error();
  }
} // namespace

TEST(Ledger, is_closed_when_every_entry_is_right)
{
  EXPECT_NEAR(Energies::from_array(closed_books(.7)).gap(), 0., 1e-12);
  EXPECT_LT(balance_error(first_dissipation, 1., "dynamics"), 1e-12);
}

TEST(Ledger, shows_five_per_cent_too_much_of_any_entry)
{
  for (unsigned int i = 0; i < Energies::n_entries; ++i)
    {
      SCOPED_TRACE(Energies::names()[i]);
      auto         e      = closed_books(.7);
      const double excess = .05 * e[i];
      ASSERT_GT(excess, 0.);
      e[i] += excess;
      EXPECT_NEAR(Energies::from_array(e).gap(),
                  i == 0 ? excess : -excess,
                  1e-12);
    }
}

TEST(Ledger, of_a_run_shows_five_per_cent_too_much_of_one_dissipation)
{
  // At the end, the largest entry is the external work.
  const auto end = closed_books(1.);
  for (unsigned int i = first_dissipation; i < Energies::n_entries; ++i)
    for (const char *strategy : {"dynamics", "quasi-static"})
      {
        SCOPED_TRACE(Energies::names()[i] + ", " + strategy);
        EXPECT_NEAR(balance_error(i, 1.05, strategy),
                    .05 * end[i] / end[0],
                    1e-12);
      }
}

TEST(Ledger, adds_and_restores_every_entry)
{
  const auto e   = closed_books(.3);
  Energies   sum = Energies::from_array(e);
  sum += Energies::from_array(e);
  const auto twice = sum.as_array();
  for (unsigned int i = 0; i < e.size(); ++i)
    EXPECT_EQ(twice[i], 2. * e[i]) << Energies::names()[i];
}

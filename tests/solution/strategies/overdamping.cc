// SPDX-License-Identifier: LGPL-2.1-or-later
// A spring that slides to rest in two steps, against the closed form.
#include "solution/overdamping.h"

#include "solution/strategies/spring.h"

#include <gtest/gtest.h>

using namespace demold;

namespace
{
  /// One implicit step with the support where it is at @p time [s].
  void step(WeakForm &form, Overdamping &dashpots, const double time)
  {
    form.begin_increment(time, 0.);
    form.move_to(time);
    form.assemble(true, 0);
    Vector du = form.new_vector();
    du(0)     = form.right_hand_side(0) / form.matrix.el(0, 0);
    form.update(du, 1.);
    form.assemble(false, 1);
    dashpots.account(form);
  }
} // namespace

TEST(Overdamping, slides_in_steps_whose_energy_is_known)
{
  const auto form = pulled_spring(1e6);
  form->begin_increment(0., 0.);
  form->assemble(true, 0);
  auto &dashpots =
    static_cast<Overdamping &>(form->add(std::make_unique<Overdamping>(*form)));
  const double c = 3., time = 1e-3, s = pull * time;
  dashpots.factor = c;

  step(*form, dashpots, time);
  const double first = s / (1. + c);
  EXPECT_NEAR(form->trial(0), first, 1e-12);
  const double taken = .5 * stiffness * (s - first) * first;
  EXPECT_NEAR(form->energies().regularisation, taken, 1e-12);
  EXPECT_NEAR(form->energies().gap(), 0., 1e-12);
  form->accept();

  // A rejected step leaves no trace.
  step(*form, dashpots, time);
  form->reject();
  EXPECT_EQ(form->energies().regularisation,
            dashpots.energies().regularisation);
  EXPECT_NEAR(dashpots.energies().regularisation, taken, 1e-12);

  step(*form, dashpots, time);
  const double second = (s + c * first) / (1. + c);
  EXPECT_NEAR(form->trial(0), second, 1e-12);
  EXPECT_NEAR(form->energies().regularisation,
              taken + .5 * stiffness *
                        (std::pow(s - first, 2) - std::pow(s - second, 2)),
              1e-12);
  EXPECT_NEAR(form->energies().gap(), 0., 1e-12);
}

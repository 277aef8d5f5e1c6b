// SPDX-License-Identifier: LGPL-2.1-or-later
// Every path constraint has the gradient it says it has, and a step along a
// path that is dropped leaves no trace.
#include "solution/cylindrical_constraint.h"
#include "solution/dissipation_constraint.h"
#include "solution/interface_constraint.h"
#include "solution/largest_opening_constraint.h"
#include "solution/path_corrector.h"
#include "solution/softening_overview.h"
#include "weak_form/block_on_mould.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace demold;

namespace
{
  /// A block pulled off a mould, bonds about to give.
  BlockOptions bonded_block()
  {
    InterfaceDescription description;
    AdhesionLaw          law;
    law.softening        = LinearSoftening{.05, .05, 20.};
    law.factors          = mode_factors(ModeMixing::energy, .6);
    description.adhesion = law;
    BlockOptions options;
    options.interface = description;
    options.top       = [](const dealii::Point<3> &, const double t) {
      return dealii::Tensor<1, 3>({.3 * t, t, 0.});
    };
    return options;
  }

  bool all(const SofteningSite &)
  {
    return true;
  }

  /// Deterministic noise [mm] on the free unknowns.
  Vector noise(const WeakForm &form, const double phase)
  {
    Vector v = form.new_vector();
    for (const auto i : v.locally_owned_elements())
      v(i) = std::sin(phase + 3. * i);
    v.compress(dealii::VectorOperation::insert);
    form.set_supports_to_zero(v);
    return v;
  }

  double value_at(WeakForm             &form,
                  const PathConstraint &constraint,
                  const unsigned int    iteration,
                  const Vector         &trial)
  {
    form.trial = trial;
    form.assemble(false, iteration);
    return constraint.value(form, iteration);
  }

  /// Compares dc/du along two directions with differences.
  void expect_gradient(PathConstraint &constraint)
  {
    BlockOnMould block(bonded_block());
    WeakForm    &form = *block.form;
    for (const double t : {.004, .008})
      ASSERT_TRUE(block.advance(t).converged);
    form.begin_increment(form.time(), 0.);
    form.assemble(false, 0);
    drive(form, all);
    constraint.start(form, .3);

    Vector trial(form.accepted);
    trial.add(2e-3, noise(form, 1.));
    for (const unsigned int iteration : {0u, 1u})
      {
        value_at(form, constraint, iteration, trial);
        Vector h = form.new_vector();
        constraint.add_gradient(form, iteration, h);
        for (const double phase : {2., 5.})
          {
            const Vector along = noise(form, phase);
            const double step  = 1e-7;
            Vector       plus(trial), minus(trial);
            plus.add(step, along);
            minus.add(-step, along);
            const double difference =
              (value_at(form, constraint, iteration, plus) -
               value_at(form, constraint, iteration, minus)) /
              (2. * step);
            EXPECT_NEAR(h * along,
                        difference,
                        1e-6 * h.l2_norm() * along.l2_norm())
              << constraint.name() << " " << iteration;
          }
      }
  }
} // namespace

TEST(PathConstraints, have_the_gradient_of_their_value)
{
  DissipationConstraint dissipation;
  expect_gradient(dissipation);
  LargestOpeningConstraint opening;
  expect_gradient(opening);
  InterfaceConstraint interface;
  expect_gradient(interface);
  CylindricalConstraint cylindrical;
  cylindrical.length = .01;
  expect_gradient(cylindrical);
}

TEST(PathStep, that_is_dropped_leaves_no_trace)
{
  BlockOnMould block(bonded_block());
  WeakForm    &form = *block.form;
  for (const double t : {.004, .008})
    ASSERT_TRUE(block.advance(t).converged);
  const std::string before = block.saved();

  NewtonParameters      parameters;
  PathCorrector         corrector(parameters, *block.solver, *block.newton);
  DissipationConstraint constraint;
  form.begin_increment(form.time(), 0.);
  form.assemble(false, 0);
  ASSERT_GT(drive(form, all), 0u);
  constraint.start(form, .3);
  corrector.solve(form, constraint, 1e-9);
  form.reject();
  EXPECT_EQ(block.saved(), before);
  EXPECT_EQ(form.trial_time(), form.time());

  // nor does a bond stay driven
  for (const SofteningSite &site : softening_sites(form))
    EXPECT_FALSE(site.driven);
}

TEST(PathStep, releases_the_energy_it_was_asked_for)
{
  BlockOnMould block(bonded_block());
  WeakForm    &form     = *block.form;
  double       critical = 0.;
  for (double t = .002; critical == 0. && t < .2; t += .002)
    {
      ASSERT_TRUE(block.advance(t).converged);
      form.begin_increment(form.time(), 0.);
      form.assemble(false, 0);
      for (const SofteningSite &site : softening_sites(form))
        critical += site.utilisation >= critical_utilisation ? 1. : 0.;
      critical = sum_over_ranks(form, critical);
    }
  ASSERT_GT(critical, 0.);
  const double before = form.energies().adhesion;

  NewtonParameters parameters;
  parameters.residual_tolerance = 1e-9;
  PathCorrector         corrector(parameters, *block.solver, *block.newton);
  DissipationConstraint constraint;
  form.begin_increment(form.time(), 0.);
  form.assemble(false, 0);
  drive(form, [](const SofteningSite &site) {
    return site.utilisation >= critical_utilisation;
  });
  double whole = 0.;
  for (const SofteningSite &site : softening_sites(form))
    if (site.driven)
      whole = std::max(whole, site.whole);
  whole = max_over_ranks(form, whole);
  constraint.start(form, .05);
  const NewtonReport report = corrector.solve(form, constraint, 1e-9);
  ASSERT_TRUE(report.converged) << report.reason;
  EXPECT_NEAR(form.energies().adhesion - before, .05 * whole, 1e-6 * whole);
}

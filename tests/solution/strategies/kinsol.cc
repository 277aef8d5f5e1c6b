// SPDX-License-Identifier: LGPL-2.1-or-later
// KINSOL finds what Newton finds and factorises each of its tangents once.
#include "solution/kinsol.h"

#include "weak_form/block_on_mould.h"

#include <gtest/gtest.h>

using namespace demold;
using dealii::Tensor;

namespace
{
  /// A block that is pressed on a mould, or on another block, and sheared.
  BlockOptions pressed_and_sheared(const bool on_block)
  {
    BlockOptions         options;
    InterfaceDescription interface;
    interface.friction         = .3;
    options.interface          = interface;
    options.on_block           = on_block;
    options.residual_tolerance = 1e-9;
    options.top                = [](const dealii::Point<3> &, const double t) {
      return Tensor<1, 3>({.02 * (t - 1.), -.04 - .01 * t, 0.});
    };
    return options;
  }

  NewtonReport advance(BlockOnMould &block, Kinsol &kinsol, const double time)
  {
    block.form->begin_increment(time, 0.);
    const NewtonReport report = kinsol.solve(*block.form);
    block.form->accept();
    return report;
  }

  NewtonParameters parameters_of(const BlockOnMould &block)
  {
    NewtonParameters parameters;
    parameters.nonlinear          = "kinsol";
    parameters.max_iterations     = 100;
    parameters.residual_tolerance = block.options.residual_tolerance;
    return parameters;
  }
} // namespace

TEST(Kinsol, factorises_each_tangent_once_and_uses_it_again)
{
  for (const bool on_block : {false, true})
    {
      SCOPED_TRACE(on_block ? "on a block" : "on a mould");
      BlockOnMould block(pressed_and_sheared(on_block));
      Kinsol       kinsol(parameters_of(block), *block.solver);
      unsigned int iterations = 0;
      for (const double time : {1., 2., 3.})
        {
          const NewtonReport report = advance(block, kinsol, time);
          ASSERT_TRUE(report.converged) << report.reason;
          iterations += report.iterations;
        }
      const LinearSolverStatistics &linear = block.solver->statistics();
      EXPECT_EQ(linear.solves, iterations);
      EXPECT_EQ(linear.factorisations, kinsol.n_tangents);
      EXPECT_GE(iterations, 2 * kinsol.n_tangents) << "nothing used again";
    }
}

TEST(Kinsol, finds_the_solution_of_newton)
{
  for (const bool on_block : {false, true})
    {
      SCOPED_TRACE(on_block ? "on a block" : "on a mould");
      BlockOnMould with_kinsol(pressed_and_sheared(on_block));
      BlockOnMould with_newton(pressed_and_sheared(on_block));
      Kinsol       kinsol(parameters_of(with_kinsol), *with_kinsol.solver);
      for (const double time : {1., 2., 3.})
        {
          ASSERT_TRUE(advance(with_kinsol, kinsol, time).converged);
          ASSERT_TRUE(with_newton.advance(time).converged);
          // Residuals are below 1e-9, for KINSOL 1e-8, of the force; the
          // condition number is some 1e3.
          Vector difference(with_kinsol.form->accepted);
          difference -= with_newton.form->accepted;
          EXPECT_LE(difference.l2_norm(),
                    1e-5 * with_newton.form->accepted.l2_norm());
          EXPECT_GT(with_newton.form->accepted.l2_norm(), .01);
        }
    }
}

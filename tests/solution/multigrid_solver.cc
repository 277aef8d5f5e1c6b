// SPDX-License-Identifier: LGPL-2.1-or-later
// Multigrid is as exact as asked for, kept while it pays, and never stuck.
// Written for any number of ranks.
#include "solution/linear_solver.h"

#include "solution/block_stiffness.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    using Outcome = LinearSolver::Outcome;

    const auto all_like_one = [](const unsigned int) { return 1.; };

    /// Shear modulus that varies from cube to cube by +- @p amount.
    std::function<double(unsigned int)> uneven(const double amount)
    {
      return [amount](const unsigned int cube) {
        return 1. + amount * std::sin(7. * cube);
      };
    }

    LinearSolverParameters parameters(const std::string &linear)
    {
      LinearSolverParameters p;
      p.linear = linear;
      return p;
    }

    Outcome solve(LinearSolver &solver,
                  TestSystem   &system,
                  const double  tolerance = 1e-8,
                  const bool    symmetric = true)
    {
      return solver
        .solve(system.A, system.x, system.b, tolerance, symmetric, false);
    }
  } // namespace


  TEST(MultigridSolver, multigrid_is_as_exact_as_asked_for)
  {
    // bulk over shear modulus 50 and 500
    for (const double bulk_modulus : {40., 400.})
      for (const double tolerance : {1e-3, 1e-8})
        {
          BlockOfCubes block(8, true);
          block.assemble(bulk_modulus, all_like_one);
          LinearSolver solver(parameters("iterative"), MPI_COMM_WORLD);
          solver.set_rigid_body_modes(block.rigid_body_modes(), 3);
          EXPECT_EQ(solve(solver, block.system, tolerance), Outcome::solved);
          EXPECT_LE(block.system.residual(), 1.001 * tolerance);
          EXPECT_EQ(solver.statistics().hierarchies, 1u);
          EXPECT_EQ(solver.statistics().factorisations, 0u);
          EXPECT_GT(solver.statistics().krylov_iterations, 0u);
          EXPECT_EQ(solver.n_negative_pivots(), -1);
        }
  }


  TEST(MultigridSolver, multigrid_iterations_hardly_grow_with_the_mesh)
  {
    std::array<unsigned int, 2> iterations;
    for (const unsigned int i : {0, 1})
      {
        BlockOfCubes block(6 * (i + 1), true);
        block.assemble(40., all_like_one);
        LinearSolver solver(parameters("iterative"), MPI_COMM_WORLD);
        solver.set_rigid_body_modes(block.rigid_body_modes(), 3);
        solve(solver, block.system);
        iterations[i] = solver.statistics().krylov_iterations;
      }
    // without coarse levels they would double
    EXPECT_LT(iterations[1], 1.5 * iterations[0]);
  }


  TEST(MultigridSolver, loose_requests_are_tightened_to_the_parameter)
  {
    LinearSolverParameters p = parameters("iterative");
    p.relative_tolerance     = 1e-5;
    BlockOfCubes block(6, true);
    block.assemble(40., all_like_one);
    LinearSolver solver(p, MPI_COMM_WORLD);
    solver.set_rigid_body_modes(block.rigid_body_modes(), 3);
    solve(solver, block.system, .1);
    EXPECT_LE(block.system.residual(), 1.001e-5);
  }


  TEST(MultigridSolver, keeps_the_hierarchy_for_a_slightly_changed_matrix)
  {
    BlockOfCubes block(8, true);
    LinearSolver solver(parameters("iterative"), MPI_COMM_WORLD);
    solver.set_rigid_body_modes(block.rigid_body_modes(), 3);
    for (const double amount : {0., .02, .04})
      {
        block.assemble(40., uneven(amount));
        EXPECT_EQ(solve(solver, block.system), Outcome::solved);
        EXPECT_LE(block.system.residual(), 1.001e-8);
      }
    EXPECT_EQ(solver.statistics().solves, 3u);
    EXPECT_EQ(solver.statistics().hierarchies, 1u);
    EXPECT_EQ(solver.statistics().factorisations, 0u);
  }


  TEST(MultigridSolver, renews_a_hierarchy_that_has_become_poor)
  {
    BlockOfCubes block(8, true);
    LinearSolver solver(parameters("iterative"), MPI_COMM_WORLD);
    solver.set_rigid_body_modes(block.rigid_body_modes(), 3);
    for (const double bulk_modulus : {1., 400.})
      {
        block.assemble(bulk_modulus, all_like_one);
        EXPECT_EQ(solve(solver, block.system, 1e-6), Outcome::solved);
        EXPECT_LE(block.system.residual(), 1.001e-6);
      }
    EXPECT_EQ(solver.statistics().hierarchies, 2u);
    EXPECT_EQ(solver.statistics().factorisations, 0u);
  }


  TEST(MultigridSolver, without_reuse_every_solution_has_its_own_hierarchy)
  {
    LinearSolverParameters p = parameters("iterative");
    p.reuse                  = false;
    BlockOfCubes block(4, true);
    block.assemble(40., all_like_one);
    LinearSolver solver(p, MPI_COMM_WORLD);
    solver.set_rigid_body_modes(block.rigid_body_modes(), 3);
    for (unsigned int i = 0; i < 3; ++i)
      solve(solver, block.system);
    EXPECT_EQ(solver.statistics().hierarchies, 3u);
  }


  TEST(MultigridSolver, a_kept_hierarchy_outlives_its_matrix)
  {
    LinearSolver solver(parameters("iterative"), MPI_COMM_WORLD);
    for (const double amount : {0., .02})
      {
        BlockOfCubes block(6, true); // gone before the next one comes
        block.assemble(40., uneven(amount));
        if (amount == 0.)
          solver.set_rigid_body_modes(block.rigid_body_modes(), 3);
        EXPECT_EQ(solve(solver, block.system), Outcome::solved);
        EXPECT_LE(block.system.residual(), 1.001e-8);
      }
    EXPECT_EQ(solver.statistics().hierarchies, 1u);
  }


  TEST(MultigridSolver, solves_unsymmetric_systems_iteratively)
  {
    BlockOfCubes block(6, true);
    block.assemble(40., all_like_one, .01);
    LinearSolver solver(parameters("iterative"), MPI_COMM_WORLD);
    solver.set_rigid_body_modes(block.rigid_body_modes(), 3);
    EXPECT_EQ(solve(solver, block.system, 1e-8, false), Outcome::solved);
    EXPECT_LE(block.system.residual(), 1.001e-8);
    EXPECT_EQ(solver.statistics().factorisations, 0u);
  }


  TEST(MultigridSolver, survives_negative_curvature)
  {
    // Cubes of negative shear modulus make the block indefinite; the direct
    // solution proves that.
    const auto broken = [](const unsigned int cube) {
      return cube % 5 == 0 ? -3. : 1.;
    };
    BlockOfCubes block(6, true);
    block.assemble(40., broken);
    LinearSolver direct(parameters("direct"), MPI_COMM_WORLD);
    EXPECT_EQ(solve(direct, block.system), Outcome::solved);
    EXPECT_GT(direct.n_negative_pivots(), 0);
    LinearSolver iterative(parameters("iterative"), MPI_COMM_WORLD);
    iterative.set_rigid_body_modes(block.rigid_body_modes(), 3);
    EXPECT_EQ(solve(iterative, block.system), Outcome::solved);
    EXPECT_LE(block.system.residual(), 1.001e-8);
  }


  TEST(MultigridSolver, falls_back_to_the_factor_where_iterations_run_out)
  {
    LinearSolverParameters p = parameters("iterative");
    p.max_iterations         = 2;
    BlockOfCubes block(5, true);
    block.assemble(400., all_like_one);
    LinearSolver solver(p, MPI_COMM_WORLD);
    solver.set_rigid_body_modes(block.rigid_body_modes(), 3);
    EXPECT_EQ(solve(solver, block.system), Outcome::solved);
    EXPECT_LE(block.system.residual(), 1e-8);
    EXPECT_EQ(solver.statistics().factorisations, 1u);
    // and does not try again at once
    solve(solver, block.system);
    EXPECT_EQ(solver.statistics().hierarchies, 1u);
    EXPECT_EQ(solver.statistics().factorisations, 2u);
  }


  TEST(MultigridSolver, a_tighter_request_is_no_reason_to_renew)
  {
    BlockOfCubes block(8, true);
    block.assemble(400., all_like_one);
    LinearSolver solver(parameters("iterative"), MPI_COMM_WORLD);
    solver.set_rigid_body_modes(block.rigid_body_modes(), 3);
    for (unsigned int i = 0; i < 4; ++i)
      for (const double tolerance : {1e-2, 1e-8})
        EXPECT_EQ(solve(solver, block.system, tolerance), Outcome::solved);
    EXPECT_EQ(solver.statistics().hierarchies, 1u);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Direct or iterative, kept or new: the solution is as exact as asked for.
// Written for any number of ranks.
#include "solution/linear_solver.h"

#include "base/parameter_error.h"
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

    TestSystem make_chain(const unsigned int n, const double diagonal)
    {
      TestSystem system(n, 0, chain(n));
      system.fill(chain(n), [diagonal](unsigned int i, unsigned int j) {
        return i == j ? diagonal : -1.;
      });
      system.make_right_hand_side();
      return system;
    }
  } // namespace


  TEST(LinearSolver, forgetting_makes_the_next_solution_repeat_exactly)
  {
    for (const std::string linear : {"iterative", "direct"})
      {
        LinearSolverParameters p = parameters(linear);
        p.reuse_factor           = true;
        BlockOfCubes block(6, true);
        LinearSolver used(p, MPI_COMM_WORLD), fresh(p, MPI_COMM_WORLD);
        used.set_rigid_body_modes(block.rigid_body_modes(), 3);
        fresh.set_rigid_body_modes(block.rigid_body_modes(), 3);
        block.assemble(40., uneven(.2));
        solve(used, block.system);
        used.forget();
        block.assemble(40., all_like_one);
        solve(used, block.system);
        const Vector x = block.system.x;
        solve(fresh, block.system);
        block.system.x -= x;
        // With several ranks sums are formed in the order of the messages.
        const bool alone =
          dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
        const double bound = alone ? 0. : 1e-10 * x.linfty_norm();
        EXPECT_LE(block.system.x.linfty_norm(), bound) << linear;
      }
  }


  TEST(LinearSolver, extra_rows_are_solved_directly)
  {
    // two springs held by one multiplier, A = [2 -1 1; -1 2 0; 1 0 0]
    const auto full = [](unsigned int) {
      return std::vector<unsigned int>{0, 1, 2};
    };
    const double a[3][3] = {{2., -1., 1.}, {-1., 2., 0.}, {1., 0., 0.}};
    TestSystem   system(2, 1, full);
    system.fill(full, [&](unsigned int i, unsigned int j) { return a[i][j]; });
    system.make_right_hand_side();
    LinearSolver solver(parameters("iterative"), MPI_COMM_WORLD);
    EXPECT_EQ(solver.solve(system.A, system.x, system.b, 1e-8, true, true),
              Outcome::solved);
    EXPECT_LT(system.error(), 1e-14);
    EXPECT_EQ(solver.statistics().hierarchies, 0u);
    EXPECT_EQ(solver.n_negative_pivots(), 1);
    EXPECT_EQ(solver.determinant_sign(), -1);
  }


  TEST(LinearSolver, auto_chooses_by_the_number_of_unknowns)
  {
    BlockOfCubes block(4, true); // 3 * 5^3 = 375 unknowns
    block.assemble(40., all_like_one);
    for (const unsigned int bound : {374u, 375u})
      {
        LinearSolverParameters p = parameters("auto");
        p.iterative_above        = bound;
        LinearSolver solver(p, MPI_COMM_WORLD);
        solve(solver, block.system);
        EXPECT_EQ(solver.statistics().hierarchies, 0u) << "no modes yet";
        solver.set_rigid_body_modes(block.rigid_body_modes(), 3);
        solve(solver, block.system);
        EXPECT_EQ(solver.statistics().hierarchies, bound < 375 ? 1u : 0u);
      }
  }


  TEST(LinearSolver, a_kept_factor_solves_a_slightly_changed_matrix)
  {
    LinearSolverParameters p = parameters("direct");
    for (const bool reuse : {true, false})
      {
        p.reuse_factor = reuse;
        BlockOfCubes block(5, true);
        LinearSolver solver(p, MPI_COMM_WORLD);
        for (const double amount : {0., .02, .04})
          {
            block.assemble(40., uneven(amount));
            EXPECT_EQ(solve(solver, block.system, 1e-6), Outcome::solved);
            EXPECT_LE(block.system.residual(), 1.001e-6);
          }
        EXPECT_EQ(solver.statistics().factorisations, reuse ? 1u : 3u);
        // the inertia of an older matrix is not that of the last one
        EXPECT_EQ(solver.n_negative_pivots(), reuse ? -1 : 0);
        // far from the kept factor: a new one
        block.assemble(4000., uneven(.9));
        EXPECT_EQ(solve(solver, block.system, 1e-8), Outcome::solved);
        EXPECT_LE(block.system.residual(), 1.001e-8);
        EXPECT_EQ(solver.statistics().factorisations, reuse ? 2u : 4u);
      }
  }


  TEST(LinearSolver, solves_again_with_what_the_same_matrix_has_left)
  {
    for (const std::string linear : {"iterative", "direct"})
      {
        BlockOfCubes block(6, true);
        LinearSolver solver(parameters(linear), MPI_COMM_WORLD);
        solver.set_rigid_body_modes(block.rigid_body_modes(), 3);
        block.assemble(40., uneven(.2));
        TestSystem &system = block.system;
        solve(solver, system);
        const auto again = [&](const double factor) {
          system.b *= factor;
          system.exact *= factor;
          EXPECT_EQ(solver.solve_again(system.A, system.x, system.b, 1e-10),
                    Outcome::solved);
          EXPECT_LE(system.residual(), 1.001e-10) << linear;
          EXPECT_LE(system.error(), 1e-6) << linear;
        };
        again(2.);
        again(-5.);
        const bool direct = linear == "direct";
        EXPECT_EQ(solver.statistics().solves, 3u);
        EXPECT_EQ(solver.statistics().factorisations, direct ? 1u : 0u);
        EXPECT_EQ(solver.statistics().hierarchies, direct ? 0u : 1u);
        // the factor is that of the matrix, and so is the inertia
        EXPECT_EQ(solver.n_negative_pivots(), direct ? 0 : -1);
        // where everything has been forgotten it is made anew
        solver.forget();
        again(.3);
        EXPECT_EQ(solver.statistics().factorisations, direct ? 2u : 0u);
        EXPECT_EQ(solver.statistics().hierarchies, direct ? 0u : 2u);
      }
  }


  TEST(LinearSolver, goes_on_counting_after_a_restart)
  {
    LinearSolverStatistics before;
    before.factorisations    = 3;
    before.hierarchies       = 5;
    before.solves            = 7;
    before.krylov_iterations = 11;
    LinearSolver solver(parameters("direct"), MPI_COMM_WORLD);
    solver.continue_from(LinearSolverStatistics::from_counts(before.counts()));
    TestSystem chain = make_chain(20, 2.);
    solve(solver, chain);
    EXPECT_EQ(solver.statistics().factorisations, 4u);
    EXPECT_EQ(solver.statistics().hierarchies, 5u);
    EXPECT_EQ(solver.statistics().solves, 8u);
    EXPECT_EQ(solver.statistics().krylov_iterations, 11u);
  }


  TEST(LinearSolver, says_that_a_matrix_is_singular)
  {
    BlockOfCubes free(4, false);
    free.assemble(40., all_like_one);
    LinearSolver solver(parameters("direct"), MPI_COMM_WORLD);
    EXPECT_EQ(solve(solver, free.system), Outcome::singular);
    EXPECT_EQ(free.system.x.linfty_norm(), 0.);
    // and goes on with the next one
    TestSystem chain = make_chain(20, 2.);
    EXPECT_EQ(solve(solver, chain), Outcome::solved);
    EXPECT_LT(chain.error(), 1e-12);
  }


  TEST(LinearSolver, zero_load_has_zero_solution)
  {
    TestSystem chain = make_chain(20, 2.);
    chain.b          = 0.;
    chain.x          = 1.;
    for (const std::string linear : {"iterative", "direct"})
      {
        LinearSolver solver(parameters(linear), MPI_COMM_WORLD);
        EXPECT_EQ(solve(solver, chain), Outcome::solved);
        EXPECT_EQ(chain.x.linfty_norm(), 0.);
      }
  }


  TEST(LinearSolver, a_load_that_is_not_a_number_is_no_reason_to_hang)
  {
    TestSystem chain = make_chain(20, 2.);
    chain.b(0)       = std::nan("");
    chain.b.compress(dealii::VectorOperation::insert);
    for (const std::string linear : {"iterative", "direct"})
      {
        LinearSolver solver(parameters(linear), MPI_COMM_WORLD);
        EXPECT_EQ(solve(solver, chain), Outcome::inaccurate);
        EXPECT_EQ(chain.x.linfty_norm(), 0.);
      }
  }


  TEST(LinearSolver, an_unknown_solver_is_bad_input)
  {
    try
      {
        parameters("fast").check();
        FAIL() << "accepted";
      }
    catch (const ExcParameter &problem)
      {
        EXPECT_NE(std::string(problem.what()).find("Solver/linear"),
                  std::string::npos);
      }
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// The direct solver solves, counts negative eigenvalues and finds singularity.
// Written for any number of ranks; with two, rank 0's rows are not contiguous.
#include "solution/mumps.h"

#include "solution/block_stiffness.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    using Status = Mumps::Status;

    const auto all_like_one = [](const unsigned int) { return 1.; };

    /// A chain of n springs whose ends and m further nodes in between are
    /// held by multipliers: saddle point with zeros on the diagonal.
    struct HeldChain
    {
      const unsigned int n, m;

      std::vector<unsigned int> columns(const unsigned int i) const
      {
        if (i >= n)
          return {held_node(i), i};
        std::vector<unsigned int> columns = chain(n)(i);
        for (unsigned int j = n; j < n + m; ++j)
          if (held_node(j) == i)
            columns.push_back(j);
        return columns;
      }

      double entry(const unsigned int i, const unsigned int j) const
      {
        if (i >= n || j >= n)
          return i == j ? 0. : 1.;
        return i == j ? 2. : -1.;
      }

      unsigned int held_node(const unsigned int multiplier) const
      {
        return (multiplier - n) * (n - 1) / (m - 1);
      }
    };

    TestSystem make_held_chain(const HeldChain &held)
    {
      const auto columns = [&](unsigned int i) { return held.columns(i); };
      TestSystem system(held.n, held.m, columns);
      system.fill(columns, [&](unsigned int i, unsigned int j) {
        return held.entry(i, j);
      });
      system.make_right_hand_side();
      return system;
    }

    TestSystem make_shifted_chain(const unsigned int n, const double shift)
    {
      TestSystem system(n, 0, chain(n));
      system.fill(chain(n), [shift](unsigned int i, unsigned int j) {
        return i == j ? 2. - shift : -1.;
      });
      system.make_right_hand_side();
      return system;
    }

    TestSystem make_two_by_two(const std::array<double, 4> &a)
    {
      const auto full = [](unsigned int) {
        return std::vector<unsigned int>{0, 1};
      };
      TestSystem system(2, 0, full);
      system.fill(full, [&a](unsigned int i, unsigned int j) {
        return a[2 * i + j];
      });
      return system;
    }
  } // namespace


  TEST(Mumps, solves_a_nearly_incompressible_block_symmetric_or_not)
  {
    for (const bool symmetric : {true, false})
      {
        BlockOfCubes block(5, true);
        block.assemble(400., all_like_one, symmetric ? 0. : .01);
        Mumps mumps(MPI_COMM_WORLD, symmetric);
        ASSERT_EQ(mumps.analyse_and_factorise(block.system.A), Status::ok);
        mumps.solve(block.system.x, block.system.b);
        // condition number: (K / G) n^2 is about 1e4
        EXPECT_LT(block.system.error(), 1e-10);
        EXPECT_GT(mumps.memory(), 0.);
      }
  }


  TEST(Mumps, solves_with_multiplier_rows_behind_the_displacements)
  {
    for (const bool symmetric : {true, false})
      {
        TestSystem system = make_held_chain({40, 4});
        Mumps      mumps(MPI_COMM_WORLD, symmetric);
        ASSERT_EQ(mumps.analyse_and_factorise(system.A), Status::ok);
        mumps.solve(system.x, system.b);
        EXPECT_LT(system.error(), 1e-11);
      }
  }


  TEST(Mumps, solves_in_place)
  {
    TestSystem system = make_shifted_chain(30, 0.);
    Mumps      mumps(MPI_COMM_WORLD, true);
    ASSERT_EQ(mumps.analyse_and_factorise(system.A), Status::ok);
    system.x = system.b;
    mumps.solve(system.x, system.x);
    EXPECT_LT(system.error(), 1e-11);
  }


  TEST(Mumps, inertia_of_two_by_two_matrices)
  {
    // det = -7: one eigenvalue of each sign
    Mumps mumps(MPI_COMM_WORLD, true);
    mumps.analyse_and_factorise(make_two_by_two({{2., 1., 1., -3.}}).A);
    EXPECT_EQ(mumps.n_negative_pivots(), 1);
    EXPECT_EQ(mumps.determinant_sign(), -1);
    // det = 5, trace < 0: two negative ones
    mumps.analyse_and_factorise(make_two_by_two({{-2., 1., 1., -3.}}).A);
    EXPECT_EQ(mumps.n_negative_pivots(), 2);
    EXPECT_EQ(mumps.determinant_sign(), 1);
    // zeros on the diagonal, eigenvalues -1 and 1
    mumps.analyse_and_factorise(make_two_by_two({{0., 1., 1., 0.}}).A);
    EXPECT_EQ(mumps.n_negative_pivots(), 1);
    EXPECT_EQ(mumps.determinant_sign(), -1);
  }


  TEST(Mumps, counts_the_eigenvalues_of_a_chain_below_a_shift)
  {
    const unsigned int n = 60;
    for (const double shift : {-.5, .1, 1.3, 2.5, 4.5})
      {
        int expected = 0;
        for (unsigned int k = 1; k <= n; ++k)
          expected += 2. - 2. * std::cos(k * M_PI / (n + 1)) < shift;
        Mumps mumps(MPI_COMM_WORLD, true);
        ASSERT_EQ(mumps.analyse_and_factorise(make_shifted_chain(n, shift).A),
                  Status::ok);
        EXPECT_EQ(mumps.n_negative_pivots(), expected) << "shift " << shift;
        EXPECT_EQ(mumps.determinant_sign(), expected % 2 == 0 ? 1 : -1);
      }
  }


  TEST(Mumps, a_saddle_point_has_one_negative_eigenvalue_per_multiplier)
  {
    Mumps mumps(MPI_COMM_WORLD, true);
    ASSERT_EQ(mumps.analyse_and_factorise(make_held_chain({40, 4}).A),
              Status::ok);
    EXPECT_EQ(mumps.n_negative_pivots(), 4);
  }


  TEST(Mumps, sign_of_the_determinant_of_unsymmetric_matrices)
  {
    Mumps mumps(MPI_COMM_WORLD, false);
    EXPECT_EQ(mumps.determinant_sign(), 0);
    mumps.analyse_and_factorise(make_two_by_two({{1., 2., 3., 4.}}).A); // -2
    EXPECT_EQ(mumps.determinant_sign(), -1);
    mumps.analyse_and_factorise(make_two_by_two({{1., -2., 3., 4.}}).A); // 10
    EXPECT_EQ(mumps.determinant_sign(), 1);
    mumps.analyse_and_factorise(make_two_by_two({{0., -1., 1., 0.}}).A); // 1
    EXPECT_EQ(mumps.determinant_sign(), 1);
    EXPECT_EQ(mumps.n_negative_pivots(), -1);
  }


  TEST(Mumps, finds_what_nothing_holds_and_recovers)
  {
    for (const bool symmetric : {true, false})
      {
        BlockOfCubes free(4, false), held(4, true);
        free.assemble(40., all_like_one);
        held.assemble(40., all_like_one);
        Mumps mumps(MPI_COMM_WORLD, symmetric);
        EXPECT_EQ(mumps.analyse_and_factorise(free.system.A), Status::singular);
        EXPECT_EQ(mumps.determinant_sign(), 0);
        EXPECT_EQ(mumps.n_negative_pivots(), -1);
        ASSERT_EQ(mumps.analyse_and_factorise(held.system.A), Status::ok);
        mumps.solve(held.system.x, held.system.b);
        EXPECT_LT(held.system.error(), 1e-10);
      }
  }


  TEST(Mumps, finds_an_empty_row)
  {
    for (const bool symmetric : {true, false})
      {
        Mumps mumps(MPI_COMM_WORLD, symmetric);
        EXPECT_EQ(mumps.analyse_and_factorise(
                    make_two_by_two({{1., 0., 0., 0.}}).A),
                  Status::singular);
      }
  }


  TEST(Mumps, keeps_the_ordering_while_the_pattern_stays)
  {
    Mumps mumps(MPI_COMM_WORLD, true);
    for (const double shift : {0., .5, 1.2})
      {
        TestSystem system = make_shifted_chain(50, shift);
        ASSERT_EQ(mumps.analyse_and_factorise(system.A), Status::ok);
        mumps.solve(system.x, system.b);
        EXPECT_LT(system.error(), 1e-9);
      }
    EXPECT_EQ(mumps.n_analyses(), 1u);
    // as many rows and entries, elsewhere
    const auto ring = [](const unsigned int i) {
      std::vector<unsigned int> columns = chain(50)(i);
      if (i == 0 || i == 1)
        columns = (i == 0) ? std::vector<unsigned int>{0, 49} :
                             std::vector<unsigned int>{1, 2};
      else if (i == 49)
        columns.push_back(0);
      return columns;
    };
    TestSystem system(50, 0, ring);
    system.fill(ring, [](unsigned int i, unsigned int j) {
      return i == j ? 3. : -1.;
    });
    system.make_right_hand_side();
    ASSERT_EQ(mumps.analyse_and_factorise(system.A), Status::ok);
    mumps.solve(system.x, system.b);
    EXPECT_LT(system.error(), 1e-11);
    EXPECT_EQ(mumps.n_analyses(), 2u);
  }
} // namespace demold

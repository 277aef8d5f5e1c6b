// SPDX-License-Identifier: LGPL-2.1-or-later
// Dual multipliers: closed forms, biorthogonality on any covered part,
// variation, and the fall-back for faces hardly covered.
#include "mortar/dual_basis.h"

#include "differences.h"
#include "faces.h"
#include "mortar/pair_gradients.h"

using namespace mortar_tests;

namespace
{
  const PairOptions options;

  /// A master over the part (a, b) x (c, d) of the unit square.
  FacetPositions
  window(const double a, const double b, const double c, const double d)
  {
    return reversed(
      quad({{{{a, c, .1}}, {{b, c, .1}}, {{b, d, .1}}, {{a, d, .1}}}}));
  }

  NodeMatrix<double> D_under(const FacetPositions &slave,
                             const FacetPositions &master)
  {
    return integrate_pair(slave, master, options).D;
  }

  NodeMatrix<double> times(const NodeMatrix<double> &a,
                           const NodeMatrix<double> &b)
  {
    NodeMatrix<double> c{};
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < 4; ++j)
        for (unsigned int k = 0; k < 4; ++k)
          c[i][j] += a[i][k] * b[k][j];
    return c;
  }

  /// A D = diag int N_A, and A applied to the constant: sum_A Phi_A = 1, the
  /// columns of A add up to one.
  void expect_dual(const NodeMatrix<double> &D, const double tolerance)
  {
    const DualBasis basis = dual_basis(D, 4);
    ASSERT_FALSE(basis.lumped);
    const auto diagonal = times(basis.A, D);
    for (unsigned int A = 0; A < 4; ++A)
      {
        double column = 0.;
        for (unsigned int B = 0; B < 4; ++B)
          {
            EXPECT_NEAR(diagonal[A][B],
                        A == B ? row_sum(D, A) : 0.,
                        tolerance * row_sum(D, A));
            column += basis.A[B][A];
          }
        EXPECT_NEAR(column, 1., 100. * tolerance);
      }
  }
} // namespace

// Theory B.7: Phi_A = (1 + 3 xi_A xi)(1 + 3 eta_A eta)/4 at the nodes.
TEST(dual_basis, of_parallelograms_is_the_known_one)
{
  FacetPositions slave = unit_square();
  slave.x[2] += vector(.3, .1, 0.);
  slave.x[3] += vector(.3, .1, 0.);
  const DualBasis basis =
    dual_basis(D_under(slave, window(-1., 2., -1., 2.)), 4);
  ASSERT_FALSE(basis.lumped);
  const double A[4][4]{{4., -2., 1., -2.},
                       {-2., 4., -2., 1.},
                       {1., -2., 4., -2.},
                       {-2., 1., -2., 4.}};
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int j = 0; j < 4; ++j)
      EXPECT_NEAR(basis.A[i][j], A[i][j], 1e-13);
}

// Phi = (1 + 3 xi_A xi)/2.
TEST(dual_basis, of_lines_is_the_known_one)
{
  const DualBasis basis =
    dual_basis(integrate_pair(line(0, 0, 2, 1), line(5, 0, -5, 0), options).D,
               2);
  ASSERT_FALSE(basis.lumped);
  EXPECT_NEAR(basis.A[0][0], 2., 1e-14);
  EXPECT_NEAR(basis.A[0][1], -1., 1e-14);
  EXPECT_EQ(basis.A[0][2], 0.);
}

TEST(dual_basis, is_dual_over_the_covered_part)
{
  Random random;
  for (unsigned int k = 0; k < 100; ++k)
    expect_dual(D_under(random.shaken(unit_square(), .1),
                        random.shaken(master_T1(), .2)),
                1e-10);
  // Corners of any size are no difficulty, in proportion to their own
  // integrals.
  for (const double r : {.5, .1, 1e-2, 1e-3})
    expect_dual(D_under(unit_square(), window(-1., r, -1., r)), 1e-10);
}

// Strips across the middle: N_A and its neighbour become the same function.
TEST(dual_basis, gives_way_to_lumping_where_functions_coincide)
{
  for (const double width : {.5, .1, .05})
    expect_dual(D_under(unit_square(),
                        window(.5 - width / 2., .5 + width / 2., -1., 2.)),
                1e-10);
  for (const double width : {1e-3, 1e-4, 1e-6, 1e-9})
    {
      const auto      D     = D_under(unit_square(),
                             window(.5 - width / 2., .5 + width / 2., -1., 2.));
      const DualBasis basis = dual_basis(D, 4);
      EXPECT_TRUE(basis.lumped) << width;
      for (unsigned int A = 0; A < 4; ++A)
        for (unsigned int B = 0; B < 4; ++B)
          EXPECT_EQ(basis.A[A][B], A == B ? 1. : 0.);
      EXPECT_NEAR(dual_D(D, 4)[0], width / 4., 1e-16);
    }
  EXPECT_TRUE(dual_basis(NodeMatrix<double>{}, 4).lumped);
}

// Both keep int Phi_A, so constants pass: sum_C M_AC = D_A.
TEST(dual_basis, keeps_constants)
{
  Random random;
  for (const double width : {.5, 1e-4})
    {
      const auto slave      = random.shaken(unit_square(), .1);
      const auto master     = window(.5 - width / 2., .5 + width / 2., -1., 2.);
      const auto pair       = integrate_pair(slave, master, options);
      const DualBasis basis = dual_basis(pair.D, 4);
      const auto      M     = dual_M(basis, pair.M);
      const auto      D     = dual_D(pair.D, 4);
      for (unsigned int A = 0; A < 4; ++A)
        EXPECT_NEAR(row_sum(M, A), D[A], 1e-12 * D[A]);
    }
}

TEST(dual_basis, changes_as_predicted)
{
  Random random;
  for (unsigned int trial = 0; trial < 10; ++trial)
    {
      const auto slave  = random.shaken(unit_square(), .1);
      const auto master = random.shaken(master_T1(), .1);
      const auto exact =
        pair_gradients(slave, master, options, DerivedBy::slave_and_master);
      const DualBasis basis = dual_basis(exact.value.D, 4);
      for (unsigned int k = 0; k < 24; ++k)
        {
          NodeMatrix<double> dD, dM;
          for (unsigned int A = 0; A < 4; ++A)
            for (unsigned int B = 0; B < 4; ++B)
              {
                dD[A][B] = exact.dD[A][B][k];
                dM[A][B] = exact.dM[A][B][k];
              }
          const auto dA     = dual_basis_change(basis, dD);
          const auto change = dual_M_change(basis, dA, exact.value.M, dM);

          // A, then A M.
          const auto numeric = derivative(
            [&](const double x) {
              FacetPositions s = slave, m = master;
              (k < 12 ? s : m).x[(k / 3) % 4][k % 3] += x;
              const auto          pair  = integrate_pair(s, m, options);
              const DualBasis     other = dual_basis(pair.D, 4);
              std::vector<double> list;
              for (const auto &matrix : {other.A, dual_M(other, pair.M)})
                for (const auto &row : matrix)
                  list.insert(list.end(), row.begin(), row.end());
              return list;
            },
            1e-4);
          for (unsigned int i = 0; i < 16; ++i)
            {
              EXPECT_NEAR(dA[i / 4][i % 4], numeric[i], 1e-6);
              EXPECT_NEAR(change[i / 4][i % 4], numeric[16 + i], 1e-8);
            }
        }
    }
}

TEST(dual_basis, does_not_change_if_lumped)
{
  NodeMatrix<double> dD{};
  dD[0][0] = 1.;
  for (const auto &row : dual_basis_change(dual_basis({}, 4), dD))
    for (const double entry : row)
      EXPECT_EQ(entry, 0.);
}

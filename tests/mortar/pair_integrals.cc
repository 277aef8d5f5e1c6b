// SPDX-License-Identifier: LGPL-2.1-or-later
// D, M and gaps of pairs with known integrals (theory B.12), in 2-D and 3-D.
#include "mortar/pair_integrals.h"

#include "faces.h"
#include "mortar/dual_basis.h"

using namespace mortar_tests;

namespace
{
  const PairOptions options;

  /// Nodal gap of node A along e_z (theory B2).
  double gap(const PairIntegrals<double> &pair,
             const FacetPositions        &slave,
             const FacetPositions        &master,
             const unsigned int           A)
  {
    double weighted = 0.;
    for (unsigned int B = 0; B < 4; ++B)
      weighted += pair.M[A][B] * master.x[B][2] - pair.D[A][B] * slave.x[B][2];
    return weighted / row_sum(pair.D, A);
  }

  void expect_row_sums(const PairIntegrals<double> &pair,
                       const std::array<double, 4> &expected,
                       const double                 tolerance)
  {
    for (unsigned int A = 0; A < 4; ++A)
      {
        EXPECT_NEAR(row_sum(pair.D, A), expected[A], tolerance);
        EXPECT_NEAR(row_sum(pair.M, A), expected[A], tolerance);
      }
  }
} // namespace

// Theory B.12, T1 to 1e-8, the digits given there.
TEST(pair_integrals, of_a_square_turned_by_45_degree)
{
  const auto pair = integrate_pair(unit_square(), master_T1(), options);
  ASSERT_TRUE(pair.overlaps);
  EXPECT_NEAR(pair.area, .68, 1e-14);
  expect_row_sums(pair, {{.17, .17, .17, .17}}, 1e-14);
  const double row[4]{.06225209, .04148124, .02478542, .04148124};
  for (unsigned int B = 0; B < 4; ++B)
    EXPECT_NEAR(pair.D[0][B], row[B], 1e-8);
  for (unsigned int A = 0; A < 4; ++A)
    EXPECT_NEAR(gap(pair, unit_square(), master_T1(), A), .1, 1e-13);

  const DualBasis basis = dual_basis(pair.D, 4);
  ASSERT_FALSE(basis.lumped);
  for (unsigned int A = 0; A < 4; ++A)
    for (unsigned int B = 0; B < 4; ++B)
      {
        double D = 0.;
        for (unsigned int C = 0; C < 4; ++C)
          D += basis.A[A][C] * pair.D[C][B];
        EXPECT_NEAR(D, A == B ? .17 : 0., 1e-14);
      }
}

// Theory B.12, T2.
TEST(pair_integrals, of_a_shifted_square)
{
  const auto pair = integrate_pair(unit_square(), master_T2(), options);
  EXPECT_NEAR(pair.area, .56, 1e-14);
  expect_row_sums(pair, {{.0784, .1456, .2184, .1176}}, 1e-14);
  const double D[4][4]{{.01951289, .02230044, .01951289, .01707378},
                       {.02230044, .05535289, .04843378, .01951289},
                       {.01951289, .04843378, .10724622, .04320711},
                       {.01707378, .01951289, .04320711, .03780622}};
  for (unsigned int A = 0; A < 4; ++A)
    {
      for (unsigned int B = 0; B < 4; ++B)
        EXPECT_NEAR(pair.D[A][B], D[A][B], 1e-8);
      EXPECT_NEAR(gap(pair, unit_square(), master_T2(), A), .05, 1e-13);
    }
}

// Theory B.12, T3. The master's node at the same place is 3 - A.
TEST(pair_integrals, of_a_square_fully_covered)
{
  const auto pair = integrate_pair(unit_square(), master_T3(), options);
  EXPECT_NEAR(pair.area, 1., 1e-14);
  expect_row_sums(pair, {{.25, .25, .25, .25}}, 1e-14);
  const double D[4][4]{{4., 2., 1., 2.},
                       {2., 4., 2., 1.},
                       {1., 2., 4., 2.},
                       {2., 1., 2., 4.}};
  for (unsigned int A = 0; A < 4; ++A)
    for (unsigned int B = 0; B < 4; ++B)
      {
        EXPECT_NEAR(pair.D[A][B], D[A][B] / 36., 1e-15);
        EXPECT_NEAR(pair.M[A][3 - B], D[A][B] / 36., 1e-15);
      }
}

// Theory B.12, T3, second half: (B3) of a master that moves .01 along x, over a
// slave that stays covered.
TEST(pair_integrals, measure_the_slip_of_a_fully_covered_square)
{
  FacetPositions before = master_T3();
  for (auto &x : before.x)
    x[0] = 1.5 * x[0] - .25;
  const FacetPositions after = moved(before, vector(.01, 0., 0.));
  const auto           M_old = integrate_pair(unit_square(), before, options).M;
  const auto           M_new = integrate_pair(unit_square(), after, options).M;
  for (unsigned int A = 0; A < 4; ++A)
    {
      double slip = 0.;
      for (unsigned int C = 0; C < 4; ++C)
        slip -= (M_new[A][C] - M_old[A][C]) * after.x[C][0];
      EXPECT_NEAR(slip, .0025, 1e-15);
      EXPECT_NEAR(slip / .25, .01, 1e-14);
    }
}

TEST(pair_integrals, do_not_depend_on_the_rule_where_all_are_exact)
{
  PairOptions six;
  six.triangle_points = 6;
  for (const FacetPositions &master : {master_T1(), master_T2(), master_T3()})
    {
      const auto a = integrate_pair(unit_square(), master, options);
      const auto b = integrate_pair(unit_square(), master, six);
      for (unsigned int A = 0; A < 4; ++A)
        for (unsigned int B = 0; B < 4; ++B)
          {
            EXPECT_NEAR(a.D[A][B], b.D[A][B], 1e-15);
            EXPECT_NEAR(a.M[A][B], b.M[A][B], 1e-15);
          }
    }
}

TEST(pair_integrals, of_faces_apart_are_empty)
{
  for (const double shift : {1., 1.5, 100.})
    {
      const FacetPositions far  = moved(master_T3(), vector(shift, 0., 0.));
      const auto           pair = integrate_pair(unit_square(), far, options);
      EXPECT_FALSE(pair.overlaps);
      EXPECT_EQ(pair.area, 0.);
    }
  EXPECT_FALSE(
    integrate_pair(line(0, 0, 1, 0), line(2, 0, 1, 0), options).overlaps);
}

// Slave from x = 0 to 2, master from 3 to 1/2 above it: with t from the left,
// N_1 = t/2 over t in (1/2, 2), and the master's first node has (t -
// 1/2)/(5/2).
TEST(pair_integrals, of_two_lines)
{
  PairOptions thick;
  thick.plane.thickness = 3.;
  const auto pair =
    integrate_pair(line(0, 0, 2, 0), line(3, .1, .5, .1), thick);
  EXPECT_NEAR(pair.area, 3. * 1.5, 1e-14);
  const double third = (8. - .125) / 3., second = (4. - .25) / 2.;
  EXPECT_NEAR(pair.D[1][1], 3. * third / 4., 1e-14);
  EXPECT_NEAR(pair.D[0][1], 3. * (second / 2. - third / 4.), 1e-14);
  EXPECT_NEAR(pair.M[1][0], 3. * (third - second / 2.) / 5., 1e-14);
  EXPECT_NEAR(row_sum(pair.M, 1), 3. * second / 2., 1e-14);
  EXPECT_EQ(pair.M[1][2], 0.);
}

// The side of a cylinder and the end of a bar, weighted with 2 pi R.
TEST(pair_integrals, of_a_body_of_revolution)
{
  PairOptions round;
  round.plane.axisymmetric = true;
  const double two_pi      = 2. * std::acos(-1.);
  const auto   side = integrate_pair(line(2, 0, 2, 3), line(2, 4, 2, 1), round);
  EXPECT_NEAR(side.area, two_pi * 2. * 2., 1e-13);
  const auto end = integrate_pair(line(2, 0, 0, 0), line(0, 0, 2, 0), round);
  EXPECT_NEAR(end.area, two_pi * 2., 1e-13);
  // int (R/2)^2 R dR over (0, 2) = 1
  EXPECT_NEAR(end.D[0][0], two_pi * 1., 1e-13);
  EXPECT_NEAR(end.M[0][1], two_pi * 1., 1e-13);
}

// A 2-D pair is a slice of a 3-D one, which is as thick as its depth.
TEST(pair_integrals, in_two_dimensions_are_those_of_a_slice)
{
  Random       random;
  const double depth = .7;
  PairOptions  thick;
  thick.plane.thickness = depth;
  for (unsigned int k = 0; k < 50; ++k)
    {
      const auto slave  = random.shaken(line(0, 0, 1, 0), .2);
      const auto master = random.shaken(line(1.3, .1, .2, .1), .2);
      // The line's normal is its direction x e_z, the quad's a_1 x a_2.
      const auto extruded = [depth](const FacetPositions &l) {
        FacetPositions q = l;
        q.n_nodes        = 4;
        q.x[2]           = l.x[1] + vector(0, 0, depth);
        q.x[3]           = l.x[0] + vector(0, 0, depth);
        return q;
      };
      const auto flat = integrate_pair(slave, master, thick);
      const auto deep =
        integrate_pair(extruded(slave), extruded(master), options);
      ASSERT_TRUE(flat.overlaps);
      EXPECT_NEAR(flat.area, deep.area, 1e-14);
      const unsigned int behind[2]{3, 2};
      for (unsigned int A = 0; A < 2; ++A)
        for (unsigned int B = 0; B < 2; ++B)
          {
            const unsigned int a = behind[A], b = behind[B];
            EXPECT_NEAR(flat.D[A][B],
                        deep.D[A][B] + deep.D[A][b] + deep.D[a][B] +
                          deep.D[a][b],
                        1e-14);
            EXPECT_NEAR(flat.M[A][B],
                        deep.M[A][B] + deep.M[A][b] + deep.M[a][B] +
                          deep.M[a][b],
                        1e-14);
          }
    }
}

TEST(pair_integrals, stay_if_everything_moves_rigidly)
{
  Random random;
  for (unsigned int k = 0; k < 50; ++k)
    {
      const auto slave  = random.shaken(unit_square(), .1);
      const auto master = random.shaken(master_T1(), .1);
      const auto R      = random.rotation();
      const auto shift  = random.vector(10.);
      const auto a      = integrate_pair(slave, master, options);
      const auto b      = integrate_pair(turned(slave, R, 1., shift),
                                    turned(master, R, 1., shift),
                                    options);
      for (unsigned int A = 0; A < 4; ++A)
        for (unsigned int B = 0; B < 4; ++B)
          {
            EXPECT_NEAR(a.D[A][B], b.D[A][B], 2e-13);
            EXPECT_NEAR(a.M[A][B], b.M[A][B], 2e-13);
          }
    }
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of D, M and the area match differences and automatic
// differentiation in every topology.
#include "mortar/pair_gradients.h"

#include "differences.h"
#include "mortar/pair_integrals.templates.h"
#include "pairs.h"

#include <Sacado.hpp>

using namespace mortar_tests;

namespace
{
  /// Differences reach 1e-8 of the largest derivative where the topology stays
  /// the same over their step. Returns how many entries have been compared.
  unsigned int expect_differences(const Pair &pair, const PairOptions &options)
  {
    constexpr double    h         = 1e-4;
    const PairGradients exact     = gradients(pair, options);
    const double        scale     = largest(exact);
    unsigned int        n_entries = 0;
    EXPECT_LT(distance(listed(exact.value), values(pair, options)), 1e-15);
    for (unsigned int k = 0; k < pair.n_dofs(); ++k)
      {
        if (pair.slave.n_nodes == 4 &&
            (topology(pair.with(k, h)) != topology(pair) ||
             topology(pair.with(k, -h)) != topology(pair)))
          continue;
        if (pair.slave.n_nodes == 2 && k % 3 == 2)
          {
            EXPECT_EQ(largest(listed(exact, k)), 0.);
            continue;
          }
        const auto numeric = derivative(
          [&](const double x) { return values(pair.with(k, x), options); },
          h);
        EXPECT_LT(distance(listed(exact, k), numeric), 1e-8 * scale)
          << pair.name << ", entry " << k;
        ++n_entries;
      }
    return n_entries;
  }

  using Number = Sacado::Fad::SFad<double, 24>;

  /// The nodes of a face as variables from @p first on.
  FaceNodes<Number> variables(const FacetPositions &face, const int first)
  {
    FaceNodes<Number> result;
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int c = 0; c < 3; ++c)
        result[i][c] = Number(24, first + 3 * i + c, face.x[i][c]);
    return result;
  }

  void expect_automatic_differentiation(const Pair        &pair,
                                        const PairOptions &options)
  {
    const PairGradients exact     = gradients(pair, options);
    const auto          automatic = integrate_pair(variables(pair.slave, 0),
                                          variables(pair.master, 12),
                                          4,
                                          options);
    const double        scale     = largest(exact);
    for (int k = 0; k < 24; ++k)
      {
        std::vector<double> other;
        for (unsigned int A = 0; A < 4; ++A)
          for (unsigned int B = 0; B < 4; ++B)
            {
              other.push_back(automatic.D[A][B].dx(k));
              other.push_back(automatic.M[A][B].dx(k));
            }
        other.push_back(automatic.area.dx(k));
        EXPECT_LE(distance(listed(exact, k), other), 1e-11 * scale)
          << pair.name << ", entry " << k;
      }
  }

} // namespace

TEST(pair_gradients, match_differences_in_every_topology)
{
  Random random;
  for (const Pair &flat : topologies())
    {
      unsigned int n_entries = expect_differences(flat, PairOptions());
      // Warped, tilted and out of every symmetry.
      for (unsigned int k = 0; k < 3; ++k)
        {
          Pair warped   = flat;
          warped.slave  = random.shaken(flat.slave, .02);
          warped.master = random.shaken(flat.master, .02);
          for (unsigned int i = 0; i < 4; ++i)
            {
              warped.slave.x[i][2] +=
                (i % 2 ? .1 : -.1) + .2 * flat.slave.x[i][0];
              warped.master.x[i][2] -= (i % 2 ? .1 : -.1);
            }
          n_entries += expect_differences(warped, PairOptions());
        }
      EXPECT_GT(n_entries, 60u) << flat.name;
    }
}

TEST(pair_gradients, match_differences_for_every_rule)
{
  Random random;
  for (const unsigned int points : {3, 6})
    {
      PairOptions options;
      options.triangle_points = points;
      Pair pair{"rule", unit_square(), random.shaken(master_T1(), .05)};
      EXPECT_EQ(expect_differences(pair, options), 24u);
    }
}

TEST(pair_gradients, match_automatic_differentiation)
{
  Random random;
  for (const Pair &pair : topologies())
    {
      expect_automatic_differentiation(pair, PairOptions());
      for (unsigned int k = 0; k < 20; ++k)
        {
          const auto R     = random.rotation();
          const auto shift = random.vector(5.);
          Pair       other = pair;
          other.slave  = turned(random.shaken(pair.slave, .1), R, 1., shift);
          other.master = turned(random.shaken(pair.master, .1), R, 1., shift);
          expect_automatic_differentiation(other, PairOptions());
        }
    }
}

// Too thin for differences, and for a centroid. With three points per triangle
// it matters where the fan's centre goes.
TEST(pair_gradients, of_slivers_match_automatic_differentiation)
{
  PairOptions options;
  options.triangle_points = 3;
  for (const double width : {1e-5, 1e-7, 1e-9})
    {
      Pair pair{"sliver", unit_square(), master_T3()};
      for (unsigned int i = 0; i < 4; ++i)
        {
          pair.master.x[i][0] += 1. - width;
          pair.master.x[i][1] = 3. * pair.master.x[i][1] - 1.1;
          pair.slave.x[i][2]  = i % 2 ? .1 : -.1;
        }
      pair.slave.x[2][1] = 1.4;
      pair.slave.x[3][1] = .7;
      EXPECT_NEAR(integrate_pair(pair.slave, pair.master, options).area,
                  1.4 * width,
                  width * width + 1e-15);
      expect_automatic_differentiation(pair, options);
    }
}

TEST(pair_gradients, by_the_slave_alone_are_the_same)
{
  Random random;
  for (const unsigned int n : {2, 4})
    {
      const Pair pair{"",
                      n == 4 ? random.shaken(unit_square(), .1) :
                               line(0., 0., 1., .1),
                      n == 4 ? random.shaken(master_T1(), .1) :
                               line(1.3, .1, .2, .1)};
      const auto both  = gradients(pair, PairOptions());
      const auto alone = gradients(pair, PairOptions(), DerivedBy::slave);
      for (unsigned int k = 0; k < 3 * n; ++k)
        EXPECT_LT(distance(listed(both, k), listed(alone, k)), 1e-16);
      for (unsigned int k = 3 * n; k < 24; ++k)
        EXPECT_EQ(largest(listed(alone, k)), 0.);
      EXPECT_EQ(listed(both.value), listed(alone.value));
    }
}

TEST(pair_gradients, of_lines_match_differences)
{
  PairOptions strain, round;
  strain.plane.thickness   = 2.;
  round.plane.axisymmetric = true;
  Random       random;
  unsigned int n_entries = 0;
  for (const auto &ends : {std::array<double, 2>{{1.4, -.3}},
                           std::array<double, 2>{{.8, .3}},
                           std::array<double, 2>{{.7, -.2}},
                           std::array<double, 2>{{1.5, .4}},
                           std::array<double, 2>{{.4, 1.5}}})
    for (const PairOptions &options : {strain, round})
      for (unsigned int k = 0; k < 5; ++k)
        {
          const Pair pair{
            "lines",
            random.shaken(line(2., 0., 3., .3), .1),
            random.shaken(line(2. + ends[0], .5, 2. + ends[1], .3), .05)};
          n_entries += expect_differences(pair, options);
        }
  EXPECT_EQ(n_entries, 5u * 2u * 5u * 8u);
}

TEST(pair_gradients, of_faces_apart_are_zero)
{
  const Pair pair{"", unit_square(), moved(master_T3(), vector(1.5, 0., 0.))};
  const auto result = gradients(pair, PairOptions());
  EXPECT_FALSE(result.value.overlaps);
  EXPECT_EQ(largest(result), 0.);
}

// Everything shifted or turned rigidly changes nothing.
TEST(pair_gradients, vanish_along_rigid_motions)
{
  Random random;
  for (const Pair &flat : topologies())
    {
      const Pair          pair{"",
                      random.shaken(flat.slave, .1),
                      random.shaken(flat.master, .1)};
      const auto          exact = gradients(pair, PairOptions());
      const auto          shift = random.vector(1.), turn = random.vector(1.);
      std::vector<double> change(33, 0.);
      for (unsigned int k = 0; k < 24; ++k)
        {
          const Point<3> &x =
            k < 12 ? pair.slave.x[k / 3] : pair.master.x[k / 3 - 4];
          const Tensor<1, 3> v =
            shift + cross_product_3d(turn, Tensor<1, 3>(x));
          const auto row = listed(exact, k);
          for (unsigned int i = 0; i < row.size(); ++i)
            change[i] += v[k % 3] * row[i];
        }
      EXPECT_LT(largest(change), 1e-14 * (1. + 100. * largest(exact)));
    }
}

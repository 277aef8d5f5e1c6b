// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the topology of a segment is about to change, integrals are continuous
// and derivatives finite and those of one side.
#include "pairs.h"

using namespace mortar_tests;

// The prediction is wrong by the square of the step, in any direction, also
// where a triangulation by diagonals would flip: nothing jumps. The topology of
// the symmetric octagon does not change.
TEST(changing_topology, is_predicted_to_second_order_in_symmetric_overlaps)
{
  Random random;
  for (const double warp : {0., .05})
    {
      Pair pair{"", unit_square(), master_T1()};
      for (unsigned int i = 0; i < 4; ++i)
        {
          pair.slave.x[i][2] += i % 2 ? warp : -warp;
          pair.master.x[i][2] += i % 2 ? warp : -warp;
        }
      const auto start = values(pair, PairOptions());
      const auto exact = gradients(pair, PairOptions());
      for (unsigned int trial = 0; trial < 20; ++trial)
        {
          std::vector<double> direction(24);
          for (double &x : direction)
            x = random(-1., 1.);
          double error[2];
          for (unsigned int s = 0; s < 2; ++s)
            {
              const double        step = s == 0 ? 1e-3 : 5e-4;
              std::vector<double> shift(direction), predicted(start);
              for (unsigned int k = 0; k < 24; ++k)
                {
                  shift[k] *= step;
                  const auto row = listed(exact, k);
                  for (unsigned int i = 0; i < row.size(); ++i)
                    predicted[i] += shift[k] * row[i];
                }
              error[s] =
                distance(predicted, values(pair.with(shift), PairOptions()));
            }
          EXPECT_LT(error[0], 20. * 1e-6);
          EXPECT_NEAR(error[0] / error[1], 4., .2);
        }
    }
}

// Aligned edges: the slave counts as covered, so the derivatives are those of
// a master that is a little larger, and of motions that keep the slave covered.
TEST(changing_topology, of_aligned_faces_takes_the_side_of_a_larger_master)
{
  std::vector<Pair> aligned{Pair{"T3", unit_square(), master_T3()},
                            Pair{"quad pair 2",
                                 unit_square(),
                                 reversed(quad({{{{0., 0., 1e-3}},
                                                 {{1., 0., 1e-3}},
                                                 {{1., 1., 1e-3}},
                                                 {{-.1, 1., 1e-3}}}}))}};
  for (const Pair &pair : aligned)
    {
      const auto exact = gradients(pair, PairOptions());
      // Outwards, along x and y, for every master node.
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int c = 0; c < 2; ++c)
          {
            const double       out = pair.master.x[i][c] > .5 ? 1. : -1.;
            const unsigned int k   = 12 + 3 * i + c;
            // One-sided differences of second order.
            constexpr double h  = 1e-5;
            const auto       f0 = values(pair, PairOptions());
            const auto       f1 = values(pair.with(k, out * h), PairOptions());
            const auto f2 = values(pair.with(k, out * 2. * h), PairOptions());
            std::vector<double> numeric(f0.size());
            for (unsigned int j = 0; j < f0.size(); ++j)
              numeric[j] = out * (4. * f1[j] - 3. * f0[j] - f2[j]) / (2. * h);
            EXPECT_LT(distance(listed(exact, k), numeric), 1e-8)
              << pair.name << ' ' << k;
          }
    }
}

// A grid over a grid of the same lines, up to rounding: along aligned edges
// nothing is divided by the angle between them. The area of a unit square under
// a master that reaches half over it changes by one per shift of the master.
TEST(changing_topology, of_nearly_aligned_faces_is_regular)
{
  Random random;
  for (unsigned int k = 0; k < 600; ++k)
    {
      const double noise = std::pow(10., -17. + (k % 15));
      const Pair   pair{"",
                      random.shaken(unit_square(), noise),
                      random.shaken(moved(master_T3(), vector(.5, 0., 0.)),
                                    noise)};
      const auto   exact = gradients(pair, PairOptions());
      EXPECT_LT(largest(exact), 1.) << noise;
      double by_shift = 0.;
      for (unsigned int i = 0; i < 4; ++i)
        by_shift += exact.darea[12 + 3 * i];
      EXPECT_NEAR(by_shift, -1., 1e-4 + 10. * noise) << noise;
    }
}

// A master of a general shape moves over a slave of a general shape; vertices
// come and go, which with three points per triangle would show up at once if
// the fan's centre jumped.
TEST(changing_topology, does_not_let_integrals_jump)
{
  PairOptions options;
  options.triangle_points = 3;
  Random       random;
  unsigned int n_changes = 0;
  for (unsigned int trial = 0; trial < 30; ++trial)
    {
      const Pair pair{"",
                      random.shaken(unit_square(), .2),
                      random.shaken(master_T1(), .2)};
      const auto at = [&](const double x) {
        Pair result   = pair;
        result.master = moved(pair.master, vector(x, .3 * x, 0.));
        return result;
      };
      for (double left = -1.; left < 1.; left += .05)
        {
          double low = left, high = left + .05;
          if (topology(at(low)) == topology(at(high)))
            continue;
          while (high - low > 1e-9)
            {
              const double middle = .5 * (low + high);
              (topology(at(middle)) == topology(at(low)) ? low : high) = middle;
            }
          ++n_changes;
          EXPECT_LT(distance(values(at(low), options),
                             values(at(high), options)),
                    2e-9);
        }
    }
  EXPECT_GT(n_changes, 100u);
}

// Nodes on a lattice of nine points: every kind of coincidence, faces without
// area, re-entrant ones, ones that cross themselves.
TEST(changing_topology, leaves_everything_finite_on_a_coarse_lattice)
{
  Random       random;
  unsigned int n_overlaps = 0, n_infinite = 0, n_row_sums = 0;
  for (unsigned int trial = 0; trial < 10000; ++trial)
    {
      Pair pair;
      pair.slave.n_nodes = pair.master.n_nodes = 4;
      for (unsigned int i = 0; i < 8; ++i)
        {
          Point<3> &x = i < 4 ? pair.slave.x[i] : pair.master.x[i - 4];
          for (unsigned int c = 0; c < 2; ++c)
            x[c] = std::floor(random(0., 3.));
          x[2] = trial % 2 ? 0. : .25 * std::floor(random(0., 3.));
        }
      const auto exact = gradients(pair, PairOptions());
      n_overlaps += exact.value.overlaps;
      bool finite = std::isfinite(largest(exact));
      for (const double x : listed(exact.value))
        finite = finite && std::isfinite(x);
      for (unsigned int k = 0; k < 24; ++k)
        for (const double x : listed(exact, k))
          finite = finite && std::isfinite(x);
      n_infinite += !finite;
      const auto value = integrate_pair(pair.slave, pair.master, PairOptions());
      for (unsigned int A = 0; A < 4; ++A)
        n_row_sums +=
          std::abs(row_sum(value.D, A) - row_sum(value.M, A)) > 1e-13;
    }
  EXPECT_GT(n_overlaps, 3000u);
  EXPECT_EQ(n_infinite, 0u);
  EXPECT_EQ(n_row_sums, 0u);
}

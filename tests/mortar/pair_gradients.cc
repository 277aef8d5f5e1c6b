// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of D, M and the area match differences and automatic
// differentiation in every topology; at a change of topology they are finite
// and those of one side.
#include "mortar/pair_gradients.h"

#include "differences.h"
#include "faces.h"
#include "mortar/pair_integrals.templates.h"

#include <Sacado.hpp>

#include <string>

using namespace mortar_tests;

namespace
{
  struct Pair
  {
    std::string    name;
    FacetPositions slave, master;

    unsigned int n_dofs() const
    {
      return 6 * slave.n_nodes;
    }

    Pair with(const std::vector<double> &shift) const
    {
      Pair result = *this;
      for (unsigned int k = 0; k < n_dofs(); ++k)
        {
          FacetPositions &face =
            k < n_dofs() / 2 ? result.slave : result.master;
          face.x[(k / 3) % slave.n_nodes][k % 3] += shift[k];
        }
      return result;
    }

    Pair with(const unsigned int k, const double shift) const
    {
      std::vector<double> all(n_dofs(), 0.);
      all[k] = shift;
      return with(all);
    }
  };

  /// D, M and the area one after the other.
  std::vector<double> listed(const PairIntegrals<double> &pair)
  {
    std::vector<double> result;
    for (unsigned int A = 0; A < 4; ++A)
      for (unsigned int B = 0; B < 4; ++B)
        {
          result.push_back(pair.D[A][B]);
          result.push_back(pair.M[A][B]);
        }
    result.push_back(pair.area);
    return result;
  }

  std::vector<double> values(const Pair &pair, const PairOptions &options)
  {
    return listed(integrate_pair(pair.slave, pair.master, options));
  }

  /// The derivatives by entry k, in the order of listed().
  std::vector<double> listed(const PairGradients &pair, const unsigned int k)
  {
    std::vector<double> result;
    for (unsigned int A = 0; A < 4; ++A)
      for (unsigned int B = 0; B < 4; ++B)
        {
          result.push_back(pair.dD[A][B][k]);
          result.push_back(pair.dM[A][B][k]);
        }
    result.push_back(pair.darea[k]);
    return result;
  }

  PairGradients
  gradients(const Pair        &pair,
            const PairOptions &options,
            const DerivedBy    derived_by = DerivedBy::slave_and_master)
  {
    return pair_gradients(pair.slave, pair.master, options, derived_by);
  }

  double largest(const std::vector<double> &list)
  {
    double result = 0.;
    for (const double x : list)
      result = std::max(result, std::abs(x));
    return result;
  }

  double largest(const PairGradients &pair)
  {
    double result = 0.;
    for (unsigned int k = 0; k < 24; ++k)
      result = std::max(result, largest(listed(pair, k)));
    return result;
  }

  double distance(const std::vector<double> &a, const std::vector<double> &b)
  {
    double result = 0.;
    for (unsigned int i = 0; i < a.size(); ++i)
      result = std::max(result, std::abs(a[i] - b[i]));
    return result;
  }

  /// What the segments are made of; empty for lines.
  std::vector<unsigned int> topology(const Pair &pair)
  {
    std::vector<unsigned int> result;
    const auto plane  = auxiliary_plane(face_nodes(pair.slave), 4);
    const auto slave  = projected(plane, face_nodes(pair.slave), 4);
    const auto master = projected(plane, face_nodes(pair.master), 4);
    const auto found  = find_segments(slave, master);
    for (unsigned int i = 0; i < found.n_segments; ++i)
      for (unsigned int v = 0; v < found.segments[i].n_vertices; ++v)
        {
          const SegmentVertex &vertex = found.segments[i].vertices[v];
          result.push_back(static_cast<unsigned int>(vertex.origin));
          result.push_back(vertex.slave[0]);
          result.push_back(vertex.master[0]);
        }
    return result;
  }

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
        EXPECT_LE(distance(listed(exact, k), other), 1e-12 * scale)
          << pair.name << ", entry " << k;
      }
  }

  /// One pair per topology. All masters look down on the unit square.
  std::vector<Pair> topologies()
  {
    const auto pair = [](const std::string &name, const Corners &x) {
      return Pair{name, unit_square(), reversed(quad(x))};
    };
    std::vector<Pair> pairs{
      Pair{"eight crossings", unit_square(), master_T1()},
      Pair{"corner on corner", unit_square(), master_T2()},
      pair("slave inside",
           {{{{-.2, -.3, .1}},
             {{1.4, -.2, .1}},
             {{1.3, 1.2, 0.}},
             {{-.1, 1.5, .1}}}}),
      pair("master inside",
           {{{{.2, .2, .1}}, {{.8, .3, 0.}}, {{.7, .8, .1}}, {{.3, .7, 0.}}}}),
      pair(
        "strip",
        {{{{.3, -1., 0.}}, {{.6, -1., .1}}, {{.7, 2., 0.}}, {{.2, 2., .1}}}}),
      pair(
        "corner cut off",
        {{{{.8, -1., .1}}, {{2., .5, .1}}, {{2., 2., .1}}, {{-1., 2., 0.}}}}),
      pair("tip",
           {{{{.8, .5, .1}}, {{2., .2, .1}}, {{3., .5, .1}}, {{2., .8, 0.}}}}),
      pair("sliver",
           {{{{.99, -1., .1}},
             {{2., -1., .1}},
             {{2., 2., .1}},
             {{.995, 2., 0.}}}}),
      pair(
        "re-entrant master",
        {{{{.1, .2, .1}}, {{.5, .4, .1}}, {{1.2, .1, .1}}, {{.5, .9, 0.}}}})};
    Pair dart{"re-entrant slave", unit_square(), master_T1()};
    dart.slave.x[2] = Point<3>(.35, .45, 0.);
    pairs.push_back(dart);
    // Quad pair 2 of Kratos' tables of test pairs, master node 1 perturbed by
    // -5e-3 in x; unperturbed it is "aligned" below.
    Pair kratos = pair("quad pair 2",
                       {{{{0., 0., 1e-3}},
                         {{1., 0., 1e-3}},
                         {{1., 1., 1e-3}},
                         {{-.1, 1., 1e-3}}}});
    kratos.master.x[1][0] -= 5e-3;
    pairs.push_back(kratos);
    return pairs;
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

// The prediction is wrong by the square of the step, in any direction, also
// where a triangulation by diagonals would flip: nothing jumps. The topology of
// the symmetric octagon does not change.
TEST(pair_gradients, predict_symmetric_overlaps_to_second_order)
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
TEST(pair_gradients, of_aligned_faces_are_those_of_a_larger_master)
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
TEST(pair_gradients, of_nearly_aligned_faces_are_regular)
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

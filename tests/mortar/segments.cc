// SPDX-License-Identifier: LGPL-2.1-or-later
// Shapes of segments: which vertices, from where, in every topology.
#include "mortar/segment_2d.h"
#include "mortar/segment_3d.h"

#include "faces.h"

#include <string>

using namespace mortar_tests;

namespace
{
  /// Of a face in the x-y plane, relative to the centre of the unit square.
  PlaneNodes<double> flat(const FacetPositions &face)
  {
    PlaneNodes<double> y;
    for (unsigned int i = 0; i < 4; ++i)
      y[i] = {{face.x[i][0] - .5, face.x[i][1] - .5}};
    return y;
  }

  /// s, m and x for each vertex: slave node, master node, crossing.
  std::string origins(const Segment3d &segment)
  {
    std::string word;
    for (unsigned int i = 0; i < segment.n_vertices; ++i)
      switch (segment.vertices[i].origin)
        {
          case SegmentVertex::Origin::slave_node:
            word += 's';
            break;
          case SegmentVertex::Origin::master_node:
            word += 'm';
            break;
          default:
            word += 'x';
        }
    return word;
  }

  /// Sorted, as the polygon may start anywhere; "" without a segment.
  std::string shape(const FacetPositions &slave, const FacetPositions &master)
  {
    const Segments3d found = find_segments(flat(slave), flat(master));
    std::string      word;
    for (unsigned int i = 0; i < found.n_segments; ++i)
      {
        std::string one = origins(found.segments[i]);
        std::sort(one.begin(), one.end());
        word += (i > 0 ? " " : "") + one;
      }
    return word;
  }

  FacetPositions master(const Corners &x)
  {
    return reversed(quad(x));
  }
} // namespace

TEST(segments, have_their_vertices_from_nodes_and_crossings)
{
  const FacetPositions slave = unit_square();
  EXPECT_EQ(shape(slave, master_T1()), "xxxxxxxx");
  EXPECT_EQ(shape(slave, master_T2()), "msxx");
  // Larger all round; inside; a strip across; a corner; only its tip.
  EXPECT_EQ(shape(slave,
                  master({{{{-1., -1., 0.}},
                           {{2., -1., 0.}},
                           {{2., 2., 0.}},
                           {{-1., 2., 0.}}}})),
            "ssss");
  EXPECT_EQ(shape(slave,
                  master({{{{.2, .2, 0.}},
                           {{.8, .3, 0.}},
                           {{.7, .8, 0.}},
                           {{.3, .7, 0.}}}})),
            "mmmm");
  EXPECT_EQ(shape(slave,
                  master({{{{.3, -1., 0.}},
                           {{.6, -1., 0.}},
                           {{.7, 2., 0.}},
                           {{.2, 2., 0.}}}})),
            "xxxx");
  EXPECT_EQ(shape(slave,
                  master({{{{.8, -1., 0.}},
                           {{2., .5, 0.}},
                           {{2., 2., 0.}},
                           {{-1., 2., 0.}}}})),
            "sssxx");
  EXPECT_EQ(shape(slave,
                  master({{{{.9, .5, 0.}},
                           {{2., .2, 0.}},
                           {{3., .5, 0.}},
                           {{2., .8, 0.}}}})),
            "mxx");
}

// What lies on an edge belongs to the slave, and there is one vertex only.
TEST(segments, of_aligned_edges_keep_the_slave_nodes)
{
  const FacetPositions slave = unit_square();
  EXPECT_EQ(shape(slave, master_T3()), "ssss");
  // Shifted along an edge: the crossings with the aligned edges do not arise.
  EXPECT_EQ(shape(slave, moved(master_T3(), vector(.5, 0., 0.))), "ssxx");
  // The same with the alignment lost in rounding.
  Random random;
  for (unsigned int k = 0; k < 100; ++k)
    {
      const FacetPositions noisy = random.shaken(slave, 1e-15);
      EXPECT_EQ(shape(noisy, master_T3()), "ssss");
      EXPECT_EQ(shape(noisy, moved(master_T3(), vector(.5, 0., 0.))), "ssxx");
    }
  // Quadrilaterals that share an edge or a corner only.
  EXPECT_EQ(shape(slave, moved(master_T3(), vector(1., 0., 0.))), "");
  EXPECT_EQ(shape(slave, moved(master_T3(), vector(1., 1., 0.))), "");
}

TEST(segments, are_the_same_whichever_way_the_master_turns)
{
  EXPECT_EQ(shape(unit_square(), reversed(master_T1())), "xxxxxxxx");
  EXPECT_EQ(shape(unit_square(), reversed(master_T2())), "msxx");
}

TEST(segments, of_faces_that_are_not_convex_are_triangles)
{
  // A dart, re-entrant at (.5, .3), inside of the slave.
  const FacetPositions dart =
    master({{{{.1, .1, 0.}}, {{.5, .3, 0.}}, {{.9, .1, 0.}}, {{.5, .9, 0.}}}});
  EXPECT_EQ(shape(unit_square(), dart), "mmm mmm");
  const PairOptions options;
  const auto        pair = integrate_pair(unit_square(), dart, options);
  // Half the cross product of the diagonals.
  EXPECT_NEAR(pair.area, .5 * .8 * .6, 1e-15);
  for (unsigned int A = 0; A < 4; ++A)
    EXPECT_NEAR(row_sum(pair.M, A), row_sum(pair.D, A), 1e-15);
  // Linear in each triangle: int N_C is a third of the triangles at C.
  const double third = pair.area / 6.;
  const double expected[4]{2. * third, third, 2. * third, third};
  for (unsigned int C = 0; C < 4; ++C)
    {
      double sum = 0.;
      for (unsigned int A = 0; A < 4; ++A)
        sum += pair.M[A][C];
      EXPECT_NEAR(sum, expected[C], 1e-15) << C;
    }
}

TEST(segments, of_faces_that_cross_themselves_are_no_larger_than_the_face)
{
  const FacetPositions bow =
    master({{{{.1, .1, 0.}}, {{.9, .1, 0.}}, {{.2, .8, 0.}}, {{.8, .8, 0.}}}});
  const auto pair = integrate_pair(unit_square(), bow, PairOptions());
  EXPECT_GT(pair.area, 0.);
  EXPECT_LT(pair.area, .8 * .7);
  EXPECT_FALSE(std::isnan(pair.M[0][0]));
}

TEST(segments, of_slaves_without_area_do_not_exist)
{
  FacetPositions nothing = unit_square();
  for (auto &x : nothing.x)
    x[1] = 0.;
  EXPECT_FALSE(integrate_pair(nothing, master_T1(), PairOptions()).overlaps);
  EXPECT_FALSE(
    integrate_pair(line(1, 1, 1, 1), line(2, 0, 0, 0), PairOptions()).overlaps);
}

// A master seen edge-on.
TEST(segments, of_masters_edge_on_do_not_exist)
{
  FacetPositions upright = master_T1();
  for (auto &x : upright.x)
    x = Point<3>(x[0], .5, x[1]);
  EXPECT_FALSE(integrate_pair(unit_square(), upright, PairOptions()).overlaps);
  EXPECT_FALSE(
    integrate_pair(line(0, 0, 1, 0), line(.5, 1, .5, 0), PairOptions())
      .overlaps);
}

TEST(segments, of_lines_end_at_the_nearer_nodes)
{
  const auto ends = [](const double m0, const double m1) {
    PlaneNodes<double> slave{}, master{};
    slave[0][0]           = -1.;
    slave[1][0]           = 1.;
    master[0][0]          = m0;
    master[1][0]          = m1;
    const Segment2d found = find_segment(slave, master);
    std::string     word;
    for (const auto &end : found.ends)
      word += (end.of_master ? 'm' : 's') + std::to_string(end.node);
    return found.exists ? word : "";
  };
  EXPECT_EQ(ends(2., -2.), "s0s1");
  EXPECT_EQ(ends(.5, -.5), "m1m0");
  EXPECT_EQ(ends(.5, -2.), "s0m0");
  EXPECT_EQ(ends(-.5, 2.), "m0s1");
  EXPECT_EQ(ends(1., -1.), "s0s1");
  EXPECT_EQ(ends(3., 1.), "");
  EXPECT_EQ(ends(0., 0.), "");
}

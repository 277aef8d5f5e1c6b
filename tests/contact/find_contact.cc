// SPDX-License-Identifier: LGPL-2.1-or-later
// Rules by which a slave node picks a face, an edge, a vertex or nothing.
#include "contact/closest_point.h"

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <vector>

namespace
{
  using namespace demold;
  using dealii::Point;
  using dealii::Tensor;

  constexpr unsigned int no_facet = dealii::numbers::invalid_unsigned_int;

  Tensor<1, 3> vector(const double x, const double y, const double z)
  {
    return Point<3>(x, y, z);
  }

  /// Searches among all facets.
  std::optional<ContactPoint> find(const Point<3>       &x,
                                   const Tensor<1, 3>   &n,
                                   const ContactSurface &surface,
                                   const ContactLimits  &limits     = {1., 1.},
                                   const unsigned int    last_facet = no_facet)
  {
    std::vector<unsigned int> all(surface.n_facets());
    std::iota(all.begin(), all.end(), 0);
    return find_contact(x, n / n.norm(), surface, all, last_facet, limits);
  }

  /// Lines through points of the x-y plane, body to the left.
  ContactSurface polyline(const std::vector<Point<3>> &x)
  {
    std::vector<Facet> facets;
    for (unsigned int i = 0; i + 1 < x.size(); ++i)
      facets.push_back({{{i, i + 1, 0, 0}}, 2});
    return ContactSurface(facets, x);
  }

  /// A polyline drawn out along e_z, n facets wide: the same outside.
  ContactSurface extruded(const std::vector<Point<3>> &x,
                          const unsigned int           n,
                          const double                 dz)
  {
    std::vector<Point<3>> nodes;
    std::vector<Facet>    facets;
    const unsigned int    m = x.size();
    for (unsigned int k = 0; k <= n; ++k)
      for (const auto &p : x)
        nodes.push_back(p + vector(0., 0., k * dz));
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int i = 0; i + 1 < m; ++i)
        facets.push_back(
          {{{k * m + i, k * m + i + 1, (k + 1) * m + i + 1, (k + 1) * m + i}},
           4});
    return ContactSurface(facets, nodes);
  }

  // Free space x > 0, y > 0; the body lies around it.
  const std::vector<Point<3>> concave_corner{Point<3>(2, 0, 0),
                                             Point<3>(0, 0, 0),
                                             Point<3>(0, 2, 0)};

  TEST(find_contact, penetrated_concave_corner_is_found_at_its_edge)
  {
    const double r     = 0.1 * std::sqrt(2.);
    const auto   plane = find(Point<3>(-0.1, -0.1, 0),
                            vector(-1, -1, 0),
                            polyline(concave_corner));
    ASSERT_TRUE(plane);
    EXPECT_EQ(plane->kind, ContactCase::vertex);
    EXPECT_EQ(plane->nodes[0], 1u);
    EXPECT_NEAR(plane->gap, -r, 1e-15);

    const auto space = find(Point<3>(-0.1, -0.1, -0.3),
                            vector(-1, -1, 0),
                            extruded(concave_corner, 2, 1.));
    EXPECT_FALSE(space); // off the free end of the edge

    const auto inside = find(Point<3>(-0.1, -0.1, 0.3),
                             vector(-1, -1, 0),
                             extruded(concave_corner, 2, 1.));
    ASSERT_TRUE(inside);
    EXPECT_EQ(inside->kind, ContactCase::edge);
    EXPECT_NEAR(inside->gap, -r, 1e-15);
  }

  TEST(find_contact, smallest_gap_wins)
  {
    // Above a valley of 90 degrees, off its middle plane.
    const auto valley =
      polyline({Point<3>(1, 1, 0), Point<3>(0, 0, 0), Point<3>(-1, 1, 0)});
    const double s = std::sqrt(0.5);
    for (const double x : {-0.1, 0.1})
      {
        const auto found = find(Point<3>(x, 0.5, 0), vector(0, -1, 0), valley);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->facet, x > 0. ? 0u : 1u);
        EXPECT_NEAR(found->gap, s * 0.4, 1e-14);
      }
  }

  TEST(find_contact, equal_gaps_go_to_the_last_facet_then_the_smallest_number)
  {
    const auto valley =
      polyline({Point<3>(1, 1, 0), Point<3>(0, 0, 0), Point<3>(-1, 1, 0)});
    const Point<3> middle(0, 0.5, 0);
    const auto     n = vector(0, -1, 0);
    EXPECT_EQ(find(middle, n, valley, {1., 1.}, 1)->facet, 1u);
    EXPECT_EQ(find(middle, n, valley, {1., 1.}, 0)->facet, 0u);
    EXPECT_EQ(find(middle, n, valley)->facet, 0u);

    // On the common edge of a flat floor rounding alone decides otherwise.
    const auto floor =
      extruded({Point<3>(2.1, 0, 0), Point<3>(1.1, 0, 0), Point<3>(0, 0, 0)},
               1,
               1.);
    const Point<3> above(1.1, 1e-14, 0.3);
    EXPECT_EQ(find(above, n, floor, {1., 1.}, 1)->facet, 1u);
    EXPECT_EQ(find(above, n, floor, {1., 1.}, 0)->facet, 0u);
  }

  TEST(find_contact, what_touches_a_face_within_round_off_touches_no_edge)
  {
    // On the common edge of an oblique plane, rounding decides whether face
    // or edge is nearer, and on which side of it the node lies.
    const auto slope = [](const double x, const double z) {
      return Point<3>(x, 0.31 * x - 0.17 * z, z);
    };
    for (int i = 1; i < 1000; ++i)
      {
        const double         a = 0.37 + 0.013 * i;
        const ContactSurface plane({{{{0, 3, 4, 1}}, 4}, {{{1, 4, 5, 2}}, 4}},
                                   {slope(a + 0.7, 0.),
                                    slope(a, 0.),
                                    slope(a - 0.9, 0.),
                                    slope(a + 0.7, 1.1),
                                    slope(a, 1.1),
                                    slope(a - 0.9, 1.1)});
        const auto up = facet_frame(plane.facet_positions(0), {}).normal;
        for (const double off : {0., 3e-15, 1e-13})
          {
            const Point<3> x     = slope(a, 0.00107 * i) + off * up;
            const auto     found = find(x, -up, plane);
            ASSERT_TRUE(found);
            ASSERT_EQ(found->kind, ContactCase::face) << i << ", " << off;
          }
      }
  }

  TEST(find_contact, foot_may_lie_two_percent_off_a_free_end_only)
  {
    const std::vector<Point<3>> floor{Point<3>(2, 0, 0), Point<3>(0, 0, 0)};
    const auto                  n = vector(0, -1, 0);
    // Half the facet is 1 mm, so xi = 1.019 is 0.019 mm off.
    for (const auto &surface : {polyline(floor), extruded(floor, 1, 2.)})
      for (const double y : {-0.05, 0.05})
        {
          const double z = surface.n_dimensions() == 2 ? 0. : 1.;
          EXPECT_TRUE(find(Point<3>(2.019, y, z), n, surface));
          EXPECT_TRUE(find(Point<3>(-0.019, y, z), n, surface));
          EXPECT_FALSE(find(Point<3>(2.021, y, z), n, surface));
          EXPECT_FALSE(find(Point<3>(-0.021, y, z), n, surface));
        }
    const auto face = extruded(floor, 1, 2.);
    EXPECT_TRUE(find(Point<3>(1, 0.05, -0.019), n, face));
    EXPECT_TRUE(find(Point<3>(1, 0.05, 2.019), n, face));
    EXPECT_FALSE(find(Point<3>(1, 0.05, -0.021), n, face));
    EXPECT_FALSE(find(Point<3>(1, 0.05, 2.021), n, face));
  }

  TEST(find_contact, overshoot_is_not_accepted_where_a_facet_follows)
  {
    // A convex edge: just beyond the end of one face comes the edge.
    const auto roof =
      polyline({Point<3>(1, -1, 0), Point<3>(0, 0, 0), Point<3>(-1, -1, 0)});
    const auto found = find(Point<3>(0, 0.01, 0), vector(0, -1, 0), roof);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->kind, ContactCase::vertex);
    EXPECT_NEAR(found->gap, 0.01, 1e-15);
  }

  TEST(find_contact, only_opposed_normals_pair)
  {
    const auto     floor = polyline({Point<3>(2, 0, 0), Point<3>(0, 0, 0)});
    const Point<3> x(1, 0.01, 0);
    const auto     at_cosine = [](const double c) {
      return vector(std::sqrt(1. - c * c), c, 0.);
    };
    EXPECT_TRUE(find(x, at_cosine(-0.21), floor));
    EXPECT_FALSE(find(x, at_cosine(-0.19), floor));
    EXPECT_FALSE(find(x, at_cosine(1.), floor));
  }

  TEST(find_contact, nothing_outside_the_limits_is_found)
  {
    const auto floor = polyline({Point<3>(2, 0, 0), Point<3>(0, 0, 0)});
    const auto n     = vector(0, -1, 0);
    EXPECT_TRUE(find(Point<3>(1, 0.29, 0), n, floor, {0.3, 0.2}));
    EXPECT_FALSE(find(Point<3>(1, 0.31, 0), n, floor, {0.3, 0.2}));
    EXPECT_TRUE(find(Point<3>(1, -0.19, 0), n, floor, {0.3, 0.2}));
    EXPECT_FALSE(find(Point<3>(1, -0.21, 0), n, floor, {0.3, 0.2}));
  }

  /// A lamella 0.4 mm thick about x = @p x, its tip at y = 0.
  std::vector<Point<3>> lamella(const double x)
  {
    return {Point<3>(x - 0.2, 2, 0),
            Point<3>(x - 0.2, 0, 0),
            Point<3>(x + 0.2, 0, 0),
            Point<3>(x + 0.2, 2, 0)};
  }

  TEST(find_contact, rubber_on_one_face_of_a_lamella_ignores_the_other)
  {
    for (const auto &surface :
         {polyline(lamella(0.)), extruded(lamella(0.), 2, 1.)})
      for (const double depth : {-0.05, 0.05})
        {
          const double z = surface.n_dimensions() == 2 ? 0. : 0.7;
          for (const double side : {-1., 1.})
            {
              const Point<3> x(side * (0.2 - depth), 1., z);
              const auto     found = find(x, vector(-side, 0, 0), surface);
              ASSERT_TRUE(found);
              EXPECT_NEAR(found->gap, -depth, 1e-14);
              EXPECT_NEAR(found->mean_normal[0], side, 1e-14);
              // Its other side belongs to rubber facing the other way.
              EXPECT_FALSE(find(x, vector(side, 0, 0), surface, {1., 0.2}));
            }
        }
  }

  TEST(find_contact, far_face_of_a_lamella_is_not_reached_through_it)
  {
    // A rubber rib of 0.4 mm fills the slot left of the lamella. A node on
    // the left side of the rib opposes the right face, 0.8 mm off.
    const auto     surface = polyline(lamella(0.));
    const Point<3> x(-0.6, 1., 0.);
    const auto     n = vector(-1, 0, 0);
    EXPECT_FALSE(find(x, n, surface, {1., 0.2}));
    // That is the depth limit's doing.
    const auto through = find(x, n, surface, {1., 1.});
    ASSERT_TRUE(through);
    EXPECT_NEAR(through->gap, -0.8, 1e-14);
  }

  TEST(find_contact, node_sliding_down_beside_a_wall_is_not_inside_its_edge)
  {
    // Outside the body x < 0, y < 0, close to its side, looking down: the top
    // opposes but does not hold the foot; the side holds it but does not
    // oppose. By the sign at the edge alone the node would be 0.5 mm inside.
    const std::vector<Point<3>> body{Point<3>(0, -2, 0),
                                     Point<3>(0, 0, 0),
                                     Point<3>(-2, 0, 0)};
    EXPECT_FALSE(
      find(Point<3>(0.05, -0.5, 0), vector(0, -1, 0), polyline(body)));
    EXPECT_FALSE(
      find(Point<3>(0.05, -0.5, 1), vector(0, -1, 0), extruded(body, 2, 1.)));
  }

  TEST(find_contact, penetrated_corner_beats_an_open_face_behind_the_wall)
  {
    // A corner whose wall is 0.3 mm thick; behind it, across 0.4 mm of air,
    // stands another wall that opposes the node just as well.
    auto                     x = concave_corner;
    const std::vector<Facet> facets{{{{0, 1, 0, 0}}, 2},
                                    {{{1, 2, 0, 0}}, 2},
                                    {{{3, 4, 0, 0}}, 2}};
    x.push_back(Point<3>(-0.7, -2, 0));
    x.push_back(Point<3>(-0.7, 2, 0));
    const auto found = find(Point<3>(-0.01, -0.01, 0),
                            vector(-1, -1, 0),
                            ContactSurface(facets, x));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->kind, ContactCase::vertex);
    EXPECT_NEAR(found->gap, -0.01 * std::sqrt(2.), 1e-15);
  }

  TEST(find_contact, a_slice_gives_what_the_plane_gives)
  {
    std::mt19937                           engine(12);
    std::uniform_real_distribution<double> random(-1., 1.);
    const std::vector<Point<3>>            outline{Point<3>(1.5, 0.2, 0),
                                        Point<3>(0.6, 0, 0),
                                        Point<3>(0, 0.5, 0),
                                        Point<3>(-0.5, -0.1, 0),
                                        Point<3>(-1.5, 0, 0)};
    const auto   plane = polyline(outline), space = extruded(outline, 3, 1.);
    unsigned int n_found = 0;
    for (unsigned int k = 0; k < 500; ++k)
      {
        const Point<3> x(random(engine), random(engine), 0.);
        const auto     n        = vector(0.3 * random(engine), -1, 0);
        const auto     in_plane = find(x, n, plane, {0.5, 0.3});
        const auto in_space = find(x + vector(0, 0, 1.3), n, space, {0.5, 0.3});
        ASSERT_EQ(in_plane.has_value(), in_space.has_value()) << x;
        if (!in_plane)
          continue;
        ++n_found;
        EXPECT_NEAR(in_plane->gap, in_space->gap, 1e-13);
        EXPECT_LT((in_plane->mean_normal - in_space->mean_normal).norm(),
                  1e-13);
      }
    EXPECT_GT(n_found, 100u);
  }
} // namespace

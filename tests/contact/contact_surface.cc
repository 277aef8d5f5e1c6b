// SPDX-License-Identifier: LGPL-2.1-or-later
// Closed surfaces: topology, normals, and distances known in closed form.
#include "contact/closest_point.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <utility>
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

  /// The box |x_i| <= half, n x n facets a side, normals outward; reversed:
  /// the cavity of that shape.
  ContactSurface box(const double half, const int n, const bool reversed)
  {
    std::map<std::array<int, 3>, unsigned int> number;
    std::vector<Point<3>>                      x;
    std::vector<Facet>                         facets;
    const auto node = [&](const std::array<int, 3> &i) {
      const auto found = number.insert({i, x.size()});
      if (found.second)
        x.push_back(Point<3>((2. * i[0] / n - 1.) * half,
                             (2. * i[1] / n - 1.) * half,
                             (2. * i[2] / n - 1.) * half));
      return found.first->second;
    };
    for (unsigned int axis = 0; axis < 3; ++axis)
      for (const int side : {0, n})
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j)
            {
              const auto at = [&](const int p, const int q) {
                std::array<int, 3> index;
                index[axis]           = side;
                index[(axis + 1) % 3] = p;
                index[(axis + 2) % 3] = q;
                return node(index);
              };
              Facet f{
                {{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}},
                4};
              if ((side == 0) != reversed)
                std::swap(f.nodes[1], f.nodes[3]);
              facets.push_back(f);
            }
    return ContactSurface(facets, x);
  }

  TEST(find_contact, gap_to_a_box_is_its_signed_distance)
  {
    std::mt19937                           engine(9);
    std::uniform_real_distribution<double> random(-1.4, 1.4);
    const auto                             surface = box(1., 3, false);
    std::map<ContactCase, unsigned int>    count;
    for (unsigned int k = 0; k < 2000; ++k)
      {
        const Point<3> x(random(engine), random(engine), random(engine));
        Tensor<1, 3>   outside;
        for (unsigned int c = 0; c < 3; ++c)
          outside[c] = std::copysign(std::max(std::abs(x[c]) - 1., 0.), x[c]);
        double       distance = outside.norm();
        Tensor<1, 3> normal   = outside;
        if (distance == 0.)
          {
            unsigned int c = 0;
            for (unsigned int i = 1; i < 3; ++i)
              c = std::abs(x[i]) > std::abs(x[c]) ? i : c;
            distance  = std::abs(x[c]) - 1.;
            normal[c] = x[c];
          }
        if (distance < -0.5)
          continue;
        const auto found = find(x, -normal, surface, {1., 0.6});
        ASSERT_TRUE(found) << x;
        EXPECT_NEAR(found->gap, distance, 1e-13) << x;
        ++count[found->kind];
      }
    for (const auto kind :
         {ContactCase::face, ContactCase::edge, ContactCase::vertex})
      EXPECT_GT(count[kind], 20u);
  }

  TEST(find_contact, penetration_of_a_cavity_is_the_distance_to_it)
  {
    std::mt19937                           engine(10);
    std::uniform_real_distribution<double> random(-1.2, 1.2);
    const auto                             surface = box(1., 2, true);
    std::map<ContactCase, unsigned int>    count;
    for (unsigned int k = 0; k < 2000; ++k)
      {
        const Point<3> x(random(engine), random(engine), random(engine));
        Tensor<1, 3>   outside;
        for (unsigned int c = 0; c < 3; ++c)
          outside[c] = std::copysign(std::max(std::abs(x[c]) - 1., 0.), x[c]);
        if (outside.norm() == 0.)
          continue;
        const auto found = find(x, outside, surface, {1., 0.4});
        ASSERT_TRUE(found) << x;
        EXPECT_NEAR(found->gap, -outside.norm(), 1e-13) << x;
        ++count[found->kind];
      }
    for (const auto kind :
         {ContactCase::face, ContactCase::edge, ContactCase::vertex})
      EXPECT_GT(count[kind], 5u);
  }

  /// Turns by 30 degrees about the axis (1,2,2)/3, Rodrigues' formula.
  Tensor<1, 3> turned(const Tensor<1, 3> &v)
  {
    const auto   k = vector(1, 2, 2) / 3.;
    const double c = std::cos(M_PI / 6.), s = std::sin(M_PI / 6.);
    return c * v + s * cross_product_3d(k, v) + (1. - c) * (k * v) * k;
  }

  TEST(find_contact, turns_with_everything_else)
  {
    std::mt19937                           engine(11);
    std::uniform_real_distribution<double> random(-1.3, 1.3);
    auto                                   surface = box(1., 3, false);
    auto                                   x       = surface.positions();
    for (auto &p : x)
      p += 0.1 * vector(random(engine), random(engine), random(engine));
    surface.set_positions(x);
    auto rotated = surface;
    for (auto &p : x)
      p = Point<3>(turned(p));
    rotated.set_positions(x);

    unsigned int n_found = 0;
    for (unsigned int k = 0; k < 1000; ++k)
      {
        const Point<3>     p(random(engine), random(engine), random(engine));
        const Tensor<1, 3> n      = -1. * p;
        const auto         before = find(p, n, surface);
        const auto after = find(Point<3>(turned(p)), turned(n), rotated);
        ASSERT_EQ(before.has_value(), after.has_value());
        if (!before)
          continue;
        ++n_found;
        EXPECT_EQ(before->kind, after->kind);
        EXPECT_EQ(before->nodes, after->nodes);
        EXPECT_NEAR(before->gap, after->gap, 1e-12);
        EXPECT_NEAR(before->xi[0], after->xi[0], 1e-11);
        EXPECT_NEAR(before->xi[1], after->xi[1], 1e-11);
        EXPECT_LT((turned(before->mean_normal) - after->mean_normal).norm(),
                  1e-12);
      }
    EXPECT_GT(n_found, 500u);
  }

  TEST(contact_surface, normals_point_out_of_a_box)
  {
    const auto surface = box(1., 2, false);
    for (unsigned int f = 0; f < surface.n_facets(); ++f)
      {
        const auto   frame   = facet_frame(surface.facet_positions(f), {});
        const double outward = frame.normal * Tensor<1, 3>(frame.x);
        EXPECT_NEAR(outward, 1., 1e-14);
      }
    for (unsigned int i = 0; i < surface.n_nodes(); ++i)
      {
        EXPECT_TRUE(surface.is_interior(i));
        // All facets around have right angles at the node, so faces count
        // equally: the signs of the coordinates that reach the surface.
        Tensor<1, 3> expected;
        for (unsigned int c = 0; c < 3; ++c)
          expected[c] = std::trunc(surface.positions()[i][c]);
        EXPECT_LT((surface.node_normal(i) - expected / expected.norm()).norm(),
                  1e-14);
      }
    // Closed surface of quadrilaterals: Euler's V - E + F = 2.
    EXPECT_EQ(surface.n_nodes() + surface.n_facets(),
              surface.edges().size() + 2u);
    for (const auto &edge : surface.edges())
      EXPECT_EQ(edge.facets.size(), 2u);
  }

  TEST(contact_surface, normal_at_a_corner_does_not_count_facets)
  {
    // The corner of the body x, y, z < 0, its top cut into two facets of 45
    // degrees, must keep the normal (1,1,1).
    const std::vector<Point<3>> x{Point<3>(0, 0, 0),
                                  Point<3>(-1, 0, 0),
                                  Point<3>(-1.5, -0.6, 0),
                                  Point<3>(-1, -1, 0),
                                  Point<3>(-0.6, -1.5, 0),
                                  Point<3>(0, -1, 0),
                                  Point<3>(0, -1, -1),
                                  Point<3>(0, 0, -1),
                                  Point<3>(-1, 0, -1)};
    const ContactSurface        surface({{{{0, 1, 2, 3}}, 4},
                                         {{{0, 3, 4, 5}}, 4},
                                         {{{0, 5, 6, 7}}, 4},
                                         {{{0, 7, 8, 1}}, 4}},
                                 x);
    EXPECT_TRUE(surface.is_interior(0));
    EXPECT_LT((surface.node_normal(0) - vector(1, 1, 1) / std::sqrt(3.)).norm(),
              1e-14);
  }

  TEST(contact_surface, rejects_neighbours_with_opposite_normals)
  {
    const std::vector<Point<3>> x{Point<3>(0, 0, 0),
                                  Point<3>(1, 0, 0),
                                  Point<3>(2, 0, 0)};
    const Facet first{{{0, 1, 0, 0}}, 2}, wrong{{{2, 1, 0, 0}}, 2};
    EXPECT_THROW(ContactSurface({first, wrong}, x), dealii::ExceptionBase);
    const Facet right{{{1, 2, 0, 0}}, 2};
    EXPECT_NO_THROW(ContactSurface({first, right}, x));
  }

  TEST(contact_surface, rejects_nodes_beyond_the_list_and_mixed_facets)
  {
    const std::vector<Point<3>> x(4);
    const Facet line{{{0, 1, 0, 0}}, 2}, face{{{0, 1, 2, 3}}, 4};
    EXPECT_THROW(ContactSurface({{{{0, 4, 0, 0}}, 2}}, x),
                 dealii::ExceptionBase);
    EXPECT_THROW(ContactSurface({line, face}, x), dealii::ExceptionBase);
  }
} // namespace

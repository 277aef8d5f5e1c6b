// SPDX-License-Identifier: LGPL-2.1-or-later
// The foot of a point on one facet is where the normal through the point
// starts.
#include "contact/closest_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
  using namespace demold;
  using dealii::Point;
  using dealii::Tensor;

  Tensor<1, 3> vector(const double x, const double y, const double z)
  {
    return Point<3>(x, y, z);
  }

  FacetPositions warped_facet(std::mt19937 &engine, const double size)
  {
    std::uniform_real_distribution<double> random(-size, size);
    FacetPositions                         facet{{{Point<3>(0, 0, 0),
                                                   Point<3>(1, 0, 0),
                                                   Point<3>(1, 1, 0),
                                                   Point<3>(0, 1, 0)}},
                         4};
    for (auto &x : facet.x)
      for (unsigned int c = 0; c < 3; ++c)
        x[c] += random(engine);
    return facet;
  }

  TEST(project, foot_on_a_plane_face_is_exact)
  {
    // A parallelogram in the plane z = x.
    const FacetPositions facet{{{Point<3>(0, 0, 0),
                                 Point<3>(2, 0, 2),
                                 Point<3>(3, 1, 3),
                                 Point<3>(1, 1, 1)}},
                               4};
    const auto           n = vector(-1, 0, 1) / std::sqrt(2.);
    const Point<3>       x(1.5, 0.5, 1.5);
    const auto           foot = project(x + 0.3 * n, facet);
    ASSERT_TRUE(foot.found);
    EXPECT_LT((foot.x - x).norm(), 1e-14);
    EXPECT_LT((foot.normal - n).norm(), 1e-14);
    EXPECT_NEAR(foot.gap, 0.3, 1e-14);
    EXPECT_NEAR(foot.xi[0], 0., 1e-14);
    EXPECT_NEAR(foot.xi[1], 0., 1e-14);
  }

  TEST(project, foot_on_a_line_is_exact)
  {
    const FacetPositions facet{{{Point<3>(0, 0, 0), Point<3>(4, 0, 0)}}, 2};
    const auto           foot = project(Point<3>(1, -0.5, 0), facet);
    ASSERT_TRUE(foot.found);
    EXPECT_NEAR(foot.xi[0], -0.5, 1e-15);
    EXPECT_NEAR(foot.gap, 0.5, 1e-15); // body to the left: outward is -y
    EXPECT_LT((foot.normal - vector(0, -1, 0)).norm(), 1e-15);
  }

  TEST(project, foot_on_a_warped_face_is_where_the_normal_started)
  {
    std::mt19937                           engine(7);
    std::uniform_real_distribution<double> random(-1., 1.);
    for (unsigned int k = 0; k < 200; ++k)
      {
        const auto             facet = warped_facet(engine, 0.2);
        const FacetCoordinates xi{{random(engine), random(engine)}};
        const auto             frame = facet_frame(facet, xi);
        const double           gap   = 0.2 * random(engine);
        const auto foot = project(frame.x + gap * frame.normal, facet);
        ASSERT_TRUE(foot.found);
        EXPECT_NEAR(foot.xi[0], xi[0], 1e-11);
        EXPECT_NEAR(foot.xi[1], xi[1], 1e-11);
        EXPECT_NEAR(foot.gap, gap, 1e-12);
        const auto d = frame.x + gap * frame.normal - foot.x;
        const auto a = facet_frame(facet, foot.xi).a;
        EXPECT_NEAR(d * a[0], 0., 1e-13);
        EXPECT_NEAR(d * a[1], 0., 1e-13);
      }
  }

  TEST(project, never_finds_a_farther_point_than_one_nearby)
  {
    std::mt19937                           engine(8);
    std::uniform_real_distribution<double> random(-1.5, 1.5);
    unsigned int                           n_found = 0;
    for (unsigned int k = 0; k < 500; ++k)
      {
        const auto     facet = warped_facet(engine, 0.45);
        const Point<3> x(random(engine), random(engine), random(engine));
        const auto     foot = project(x, facet);
        if (!foot.found)
          continue;
        ++n_found;
        for (const double d1 : {-1e-3, 0., 1e-3})
          for (const double d2 : {-1e-3, 0., 1e-3})
            {
              const auto near =
                facet_frame(facet, {{foot.xi[0] + d1, foot.xi[1] + d2}}).x;
              EXPECT_LE((x - foot.x).norm(), (x - near).norm() + 1e-14);
            }
      }
    EXPECT_GT(n_found, 400u);
  }

  TEST(project, reports_a_facet_without_area_as_not_found)
  {
    const Point<3> p(1, 1, 1);
    EXPECT_FALSE(project(Point<3>(), {{{p, p, p, p}}, 4}).found);
    EXPECT_FALSE(project(Point<3>(), {{{p, p, p, p}}, 2}).found);
  }
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// The segments of a slave part its area among its masters: nothing is missed,
// nothing counted twice, nothing is not a number, to 1e-12 of the slave's area.
#include "faces.h"

#include <functional>

using namespace mortar_tests;

namespace
{
  const PairOptions options;

  /// Faces of a grid of nodes given by two parameters.
  std::vector<FacetPositions>
  grid(const unsigned int                                         nx,
       const unsigned int                                         ny,
       const std::function<Point<3>(unsigned int, unsigned int)> &node)
  {
    std::vector<FacetPositions> faces;
    for (unsigned int i = 0; i < nx; ++i)
      for (unsigned int j = 0; j < ny; ++j)
        {
          FacetPositions face;
          face.n_nodes = 4;
          face.x[0]    = node(i, j);
          face.x[1]    = node(i, j + 1);
          face.x[2]    = node(i + 1, j + 1);
          face.x[3]    = node(i + 1, j);
          faces.push_back(face);
        }
    return faces;
  }

  struct Sums
  {
    double area = 0., D = 0., M = 0., worst_row = 0.;
  };

  Sums summed(const FacetPositions              &slave,
              const std::vector<FacetPositions> &masters)
  {
    Sums sums;
    for (const FacetPositions &master : masters)
      {
        const auto pair = integrate_pair(slave, master, options);
        sums.area += pair.area;
        for (unsigned int A = 0; A < 4; ++A)
          {
            const double D = row_sum(pair.D, A), M = row_sum(pair.M, A);
            sums.D += D;
            sums.M += M;
            sums.worst_row = std::max(sums.worst_row, std::abs(D - M));
          }
      }
    return sums;
  }

  /// False also for anything that is not a number.
  bool parted(const Sums &sums, const double expected, const double slave_area)
  {
    const double tolerance = 1e-12 * slave_area;
    return std::abs(sums.area - expected) <= tolerance &&
           std::abs(sums.D - expected) <= tolerance &&
           std::abs(sums.M - expected) <= tolerance &&
           sums.worst_row <= tolerance;
  }

  /// A slave in [-1,1]^2 and masters over [-2,2]^2, curved by @p height.
  struct Configuration
  {
    FacetPositions              slave;
    std::vector<FacetPositions> masters;

    void turn(Random &random)
    {
      const auto   R     = random.rotation();
      const auto   shift = random.vector(30.);
      const double scale = std::pow(10., random(-1., 1.));
      slave              = turned(slave, R, scale, shift);
      for (FacetPositions &master : masters)
        master = turned(master, R, scale, shift);
    }
  };

  FacetPositions square(const double size)
  {
    return quad({{{{-size, -size, 0.}},
                  {{size, -size, 0.}},
                  {{size, size, 0.}},
                  {{-size, size, 0.}}}});
  }

  /// Random inner nodes, moved by up to @p shake of a cell.
  std::vector<FacetPositions> surface(Random      &random,
                                      const double shake,
                                      const double height)
  {
    const unsigned int    n = 1 + static_cast<unsigned int>(random(0., 6.));
    std::vector<Point<3>> nodes;
    for (unsigned int i = 0; i <= n; ++i)
      for (unsigned int j = 0; j <= n; ++j)
        {
          const bool   inner = i > 0 && i < n && j > 0 && j < n;
          const double h     = 4. / n;
          const double x = -2. + h * (i + (inner ? random(-shake, shake) : 0.));
          const double y = -2. + h * (j + (inner ? random(-shake, shake) : 0.));
          nodes.emplace_back(x, y, .2 + height * std::sin(x + 2. * y));
        }
    return grid(n, n, [&](const unsigned int i, const unsigned int j) {
      return nodes[i * (n + 1) + j];
    });
  }
} // namespace

// Warped slaves of many shapes, far from convex masters among the others, on
// flat and on curved surfaces.
TEST(area_partition, of_random_faces_is_complete)
{
  Random       random;
  unsigned int failures = 0;
  for (unsigned int k = 0; k < 5000; ++k)
    {
      Configuration c;
      c.slave   = random.shaken(square(.5), .2);
      c.masters = surface(random, k % 2 ? .2 : .45, k % 3 ? .1 : 0.);
      c.turn(random);
      const double area = projected_area(c.slave);
      failures += !parted(summed(c.slave, c.masters), area, area);
    }
  EXPECT_EQ(failures, 0u);
}

// Lines of the grid along edges and through corners of the slave, exactly or up
// to 1e-16, 1e-14, ... 1e-6.
TEST(area_partition, of_touching_faces_is_complete)
{
  Random       random;
  unsigned int failures = 0;
  for (unsigned int k = 0; k < 3000; ++k)
    {
      const unsigned int n = 1 + k % 5;
      const double  noise  = k % 7 ? std::pow(10., -18. + 2. * (k % 7)) : 0.;
      Configuration c;
      c.slave = random.shaken(square(.5), noise);
      // Lines at multiples of 1/n from the corner of the slave.
      c.masters = grid(3 * n, 3 * n, [&](unsigned int i, unsigned int j) {
        return Point<3>(-1.5 + double(i) / n, -1.5 + double(j) / n, .1);
      });
      if (k % 2)
        c.turn(random);
      const double area = projected_area(c.slave);
      failures += !parted(summed(c.slave, c.masters), area, area);
    }
  EXPECT_EQ(failures, 0u);
}

// Masters a thousand times smaller and a thousand times larger than the slave.
TEST(area_partition, of_tiny_and_of_huge_masters_is_complete)
{
  Random       random;
  unsigned int failures = 0;
  for (unsigned int k = 0; k < 1000; ++k)
    {
      Configuration c;
      const bool    huge = k % 2;
      c.slave = random.shaken(square(huge ? 1e-3 : .5), huge ? 4e-4 : .2);
      if (huge)
        c.masters = surface(random, .2, .1);
      else
        {
          // Strips, the widths of which fall from 2 to 1e-6 towards x = 0.
          std::vector<double> x{-2.};
          for (int p = 0; p <= 6; ++p)
            x.push_back(-std::pow(10., -p) * random(.5, 1.));
          for (int p = 6; p >= 0; --p)
            x.push_back(std::pow(10., -p) * random(.5, 1.));
          x.push_back(2.);
          c.masters =
            grid(x.size() - 1, 4, [&](unsigned int i, unsigned int j) {
              return Point<3>(x[i], -2. + j, .1);
            });
        }
      c.turn(random);
      const double area = projected_area(c.slave);
      failures += !parted(summed(c.slave, c.masters), area, area);
    }
  EXPECT_EQ(failures, 0u);
}

// Triangles as quadrilaterals with a repeated node, on either side; masters
// without area.
TEST(area_partition, of_degenerate_faces_is_complete)
{
  Random       random;
  unsigned int failures = 0;
  for (unsigned int k = 0; k < 1000; ++k)
    {
      Configuration c;
      c.slave = random.shaken(square(.5), .2);
      if (k % 2)
        c.slave.x[(k / 2 + 1) % 4] = c.slave.x[(k / 2) % 4];
      const std::vector<FacetPositions> whole = surface(random, .2, .1);
      for (const FacetPositions &face : whole)
        for (unsigned int half = 0; half < 2; ++half)
          {
            FacetPositions triangle       = face;
            triangle.x[half == 0 ? 3 : 1] = face.x[half == 0 ? 2 : 0];
            c.masters.push_back(triangle);
          }
      FacetPositions nothing = whole[0];
      nothing.x[2]           = nothing.x[1];
      nothing.x[3]           = nothing.x[0];
      c.masters.push_back(nothing);
      c.turn(random);
      const double area = projected_area(c.slave);
      failures += !parted(summed(c.slave, c.masters), area, area);
    }
  EXPECT_EQ(failures, 0u);
}

// The part covered by a grid is the part covered by its outline.
TEST(area_partition, of_partly_covered_faces_is_that_of_the_outline)
{
  Random       random;
  unsigned int failures = 0, partly = 0;
  for (unsigned int k = 0; k < 1000; ++k)
    {
      Configuration c;
      const double  shift = random(-.7, .7);
      c.slave             = random.shaken(square(.5), .2);
      const double width  = random(.1, 1.);
      c.masters = grid(3, 4, [&](const unsigned int i, const unsigned int j) {
        return Point<3>(shift + width * i / 3., -.6 + j * .3, .1);
      });
      c.masters.push_back(grid(1, 1, [&](unsigned int i, unsigned int j) {
        return Point<3>(shift + width * i, -.6 + j * 1.2, .1);
      })[0]);
      c.turn(random);
      const FacetPositions outline = c.masters.back();
      c.masters.pop_back();
      const double area = projected_area(c.slave);
      const double part = integrate_pair(c.slave, outline, options).area;
      failures += !parted(summed(c.slave, c.masters), part, area);
      partly += part > 0.01 * area && part < 0.99 * area;
    }
  EXPECT_EQ(failures, 0u);
  EXPECT_GT(partly, 500u);
}

// Closed form: a square turned by any angle about the centre of an equal one.
// Between 0 and 90 degree the common area is 1/(1 + s + c) times two.
TEST(area_partition, of_a_turned_square_is_its_closed_form)
{
  for (unsigned int degree = 0; degree <= 90; ++degree)
    {
      const double   a = degree * std::acos(-1.) / 180.;
      const double   c = std::cos(a), s = std::sin(a);
      FacetPositions master = reversed(square(.5));
      for (auto &x : master.x)
        x = Point<3>(c * x[0] - s * x[1], s * x[0] + c * x[1], .1);
      EXPECT_NEAR(integrate_pair(square(.5), master, options).area,
                  2. / (1. + s + c),
                  1e-14)
        << degree;
    }
}

// Lines in the plane, touching, tiny, and longer than the slave.
TEST(area_partition, of_lines_is_complete)
{
  Random       random;
  unsigned int failures = 0;
  for (unsigned int k = 0; k < 2000; ++k)
    {
      const FacetPositions  slave = random.shaken(line(-1, 0, 1, 0), .3);
      const unsigned int    n     = 1 + k % 7;
      std::vector<Point<3>> nodes;
      for (unsigned int i = 0; i <= n; ++i)
        nodes.emplace_back(2. - 4. * i / n + (i % n ? random(-.2, .2) / n : 0.),
                           .2 + random(-.05, .05),
                           0.);
      if (k % 3 == 0 && n > 1)
        nodes[1] = slave.x[1];
      if (k % 5 == 0 && n > 2)
        nodes[2] = nodes[1] + vector(-1e-13, 0., 0.);
      std::vector<FacetPositions> masters;
      for (unsigned int i = 0; i < n; ++i)
        masters.push_back(
          line(nodes[i][0], nodes[i][1], nodes[i + 1][0], nodes[i + 1][1]));
      const double length = (slave.x[1] - slave.x[0]).norm();
      failures += !parted(summed(slave, masters), length, length);
    }
  EXPECT_EQ(failures, 0u);
}

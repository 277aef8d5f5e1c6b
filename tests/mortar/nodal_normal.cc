// SPDX-License-Identifier: LGPL-2.1-or-later
// Averaged nodal normals: closed forms, derivatives, rigid motions.
#include "mortar/nodal_normal.h"

#include "differences.h"
#include "faces.h"

using namespace mortar_tests;

namespace
{
  /// Warped faces around a node, the node at a random corner of each. In 2-D
  /// the two lines at a node.
  std::vector<FaceAround> faces_around(Random &random, const unsigned int dim)
  {
    std::vector<FaceAround> around;
    if (dim == 2)
      {
        const FacetPositions first = random.shaken(line(0, 0, 1, 0), .2);
        FacetPositions       next  = random.shaken(line(1, 0, 2, .3), .2);
        next.x[0]                  = first.x[1];
        around.push_back({first, 1});
        around.push_back({next, 0});
        return around;
      }
    const Tensor<1, 3> node = random.vector(.1);
    for (unsigned int e = 0; e < 4; ++e)
      {
        const double   turn = e * std::acos(0.);
        const double   c = std::cos(turn), s = std::sin(turn);
        FacetPositions face = unit_square();
        face.x[0]           = Point<3>(node);
        for (unsigned int i = 1; i < 4; ++i)
          {
            const Point<3> x = face.x[i];
            face.x[i] = Point<3>(c * x[0] - s * x[1], s * x[0] + c * x[1], 0.);
            face.x[i] += random.vector(.2);
          }
        // The same face, numbered from another corner.
        const unsigned int corner = e;
        FacetPositions     other  = face;
        for (unsigned int i = 0; i < 4; ++i)
          other.x[(i + corner) % 4] = face.x[i];
        around.push_back({other, corner});
      }
    return around;
  }

  /// dn . v for velocities of all nodes of all faces.
  template <typename Velocity>
  Tensor<1, 3> change(const std::vector<FaceAround> &around,
                      const NodalNormal             &normal,
                      const Velocity                &velocity)
  {
    Tensor<1, 3> sum;
    for (unsigned int e = 0; e < around.size(); ++e)
      for (unsigned int I = 0; I < around[e].face.n_nodes; ++I)
        sum += normal.dn[e][I] * velocity(around[e].face.x[I]);
    return sum;
  }
} // namespace

// Three faces of a cube at its corner; one face twice as large as the others
// does not count more.
TEST(nodal_normal, of_the_corner_of_a_cube_is_its_diagonal)
{
  std::vector<FaceAround> around;
  around.push_back(
    {quad({{{{0, 0, 0}}, {{-2, 0, 0}}, {{-2, -2, 0}}, {{0, -2, 0}}}}), 0});
  around.push_back(
    {quad({{{{0, 0, 0}}, {{0, 0, -1}}, {{-1, 0, -1}}, {{-1, 0, 0}}}}), 0});
  around.push_back(
    {quad({{{{0, 0, 0}}, {{0, -1, 0}}, {{0, -1, -1}}, {{0, 0, -1}}}}), 0});
  const Tensor<1, 3> n = nodal_normal(around).n;
  for (unsigned int c = 0; c < 3; ++c)
    EXPECT_NEAR(n[c], 1. / std::sqrt(3.), 1e-15);
}

// Two lines of length 1 and 3 that enclose 60 degree: the bisector. The body
// lies to the left, so outside is to the right.
TEST(nodal_normal, of_two_lines_is_their_bisector)
{
  const double                  c = .5, s = std::sqrt(3.) / 2.;
  const std::vector<FaceAround> around{{line(-1., 0., 0., 0.), 1},
                                       {line(0., 0., 3. * c, 3. * s), 0}};
  const Tensor<1, 3>            n = nodal_normal(around).n;
  EXPECT_NEAR(n[0], .5, 1e-15);
  EXPECT_NEAR(n[1], -s, 1e-15);
  EXPECT_EQ(n[2], 0.);
}

// A line turns with v/L, towards -t if its far end moves along n.
TEST(nodal_normal, of_one_line_turns_with_it)
{
  const NodalNormal normal = nodal_normal({{line(0., 0., 2., 0.), 0}});
  EXPECT_NEAR((normal.n - vector(0., -1., 0.)).norm(), 0., 1e-16);
  EXPECT_NEAR(normal.dn[0][1][0][1], .5, 1e-16);
  EXPECT_NEAR(normal.dn[0][0][0][1], -.5, 1e-16);
  EXPECT_NEAR(normal.dn[0][1][0][0], 0., 1e-16);
}

TEST(nodal_normal, derivatives_match_differences)
{
  Random random;
  for (unsigned int k = 0; k < 40; ++k)
    {
      const unsigned int      dim    = k % 2 ? 2 : 3;
      std::vector<FaceAround> around = faces_around(random, dim);
      const NodalNormal       normal = nodal_normal(around);
      EXPECT_NEAR(normal.n.norm(), 1., 1e-15);
      EXPECT_LT((normal.n - nodal_normal_value(around)).norm(), 1e-16);
      for (unsigned int e = 0; e < around.size(); ++e)
        for (unsigned int I = 0; I < around[e].face.n_nodes; ++I)
          for (unsigned int j = 0; j < dim; ++j)
            {
              const auto numeric = derivative(
                [&](const double x) {
                  std::vector<FaceAround> other = around;
                  other[e].face.x[I][j] += x;
                  const Tensor<1, 3> n = nodal_normal_value(other);
                  return std::vector<double>{n[0], n[1], n[2]};
                },
                1e-3);
              for (unsigned int i = 0; i < 3; ++i)
                EXPECT_NEAR(normal.dn[e][I][i][j], numeric[i], 1e-8);
            }
    }
}

TEST(nodal_normal, follows_rigid_motions)
{
  Random random;
  for (unsigned int k = 0; k < 20; ++k)
    {
      const auto        around = faces_around(random, 3);
      const NodalNormal normal = nodal_normal(around);
      const auto        shift = random.vector(1.), turn = random.vector(1.);
      const auto        shifted =
        change(around, normal, [&](const Point<3> &) { return shift; });
      EXPECT_LT(shifted.norm(), 1e-14);
      const auto turned = change(around, normal, [&](const Point<3> &x) {
        return cross_product_3d(turn, Tensor<1, 3>(x));
      });
      EXPECT_LT((turned - cross_product_3d(turn, normal.n)).norm(), 1e-14);
      EXPECT_LT(std::abs(turned * normal.n), 1e-14);
    }
}

TEST(nodal_normal, does_not_exist_without_faces_or_between_opposite_ones)
{
  EXPECT_EQ(nodal_normal({}).n.norm(), 0.);
  FacetPositions nothing = unit_square();
  for (auto &x : nothing.x)
    x[1] = 0.;
  const FaceAround flat{unit_square(), 0}, other{reversed(unit_square()), 3};
  EXPECT_EQ(nodal_normal({{nothing, 0}}).n.norm(), 0.);
  EXPECT_EQ(nodal_normal({flat, other}).n.norm(), 0.);
  // A face without area does not count, and moves nothing.
  const NodalNormal normal = nodal_normal({flat, {nothing, 0}});
  EXPECT_NEAR(normal.n[2], 1., 1e-16);
  for (const Tensor<2, 3> &dn : normal.dn[1])
    EXPECT_EQ(dn.norm(), 0.);
}

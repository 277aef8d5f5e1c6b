// SPDX-License-Identifier: LGPL-2.1-or-later
// The mould lies on the rubber, faces it, and does not share its mesh.
#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/boundary_names.h"
#include "geometry/tread_block.h"

using namespace demold;
using dealii::cross_product_3d;
using dealii::Point;
using dealii::Tensor;
using dealii::Triangulation;

namespace
{
  TreadBlock block_with(const unsigned int sipes, const std::string &symmetry)
  {
    TreadBlock block;
    block.sipes             = sipes;
    block.symmetry          = symmetry;
    block.base_overhang     = 1;
    block.element_size      = 2;
    block.wall_element_size = 1;
    block.facet_size        = 1.3;
    return block;
  }

  struct RubberFace
  {
    Point<3>     centre;
    Tensor<1, 3> outward;
    Boundary::Id id;
  };

  // Contact faces; the outward normal points away from the cell's centre.
  template <int dim>
  std::vector<RubberFace> rubber_faces(const TreadBlock &block)
  {
    Triangulation<dim> mesh;
    make_tread_block(block, mesh);
    std::vector<RubberFace> faces;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        {
          if (!face->at_boundary())
            continue;
          const Boundary::Id id = face->boundary_id();
          if (id != Boundary::bottom && id != Boundary::wall &&
              id != Boundary::sipe && id != Boundary::groove)
            continue;
          const auto in_space = [](const Point<dim> &p) {
            return Point<3>(p[0], p[1], dim == 3 ? p[dim - 1] : 0);
          };
          const auto x = [&](const unsigned int v) {
            return in_space(face->vertex(v));
          };
          RubberFace   rubber{in_space(face->center()), {}, id};
          Tensor<1, 3> n;
          if (dim == 3)
            n = cross_product_3d(x(3) - x(0), x(2) - x(1));
          else
            {
              n[0] = x(1)[1] - x(0)[1];
              n[1] = x(0)[0] - x(1)[0];
            }
          const double sign =
            n * (rubber.centre - in_space(cell->center())) > 0 ? 1 : -1;
          rubber.outward = sign * n / n.norm();
          faces.push_back(rubber);
        }
    return faces;
  }

  // Is the foot of the perpendicular inside a (convex, plane) facet?
  bool is_over(const RigidSurface &mould, const unsigned int facet, Point<3> p)
  {
    const auto  &f = mould.facets[facet];
    const auto   n = facet_normal(mould, facet);
    const double h = std::sqrt(facet_area(mould, facet));
    if (f.n == 2)
      {
        const Tensor<1, 3> t = mould.vertices[f.v[1]] - mould.vertices[f.v[0]];
        const double s = (p - mould.vertices[f.v[0]]) * t / t.norm_square();
        return s > -1e-9 && s < 1 + 1e-9;
      }
    for (unsigned int i = 0; i < 4; ++i)
      {
        const Point<3> a = mould.vertices[f.v[i]];
        const Point<3> b = mould.vertices[f.v[(i + 1) % 4]];
        if (cross_product_3d(b - a, p - a) * n < -1e-9 * h * h)
          return false;
      }
    return true;
  }

  // Largest distance of a rubber face to the facets it lies on; infinite if
  // it lies on none that faces it.
  template <int dim>
  double largest_distance(const TreadBlock &block)
  {
    const RigidSurface mould   = make_mould(block, dim);
    double             largest = 0;
    for (const RubberFace &face : rubber_faces<dim>(block))
      {
        double nearest = INFINITY;
        for (unsigned int f = 0; f < mould.facets.size(); ++f)
          {
            const auto n = facet_normal(mould, f);
            if (n * face.outward > -1 + 1e-10 ||
                !is_over(mould, f, face.centre))
              continue;
            nearest =
              std::min(nearest,
                       std::abs((face.centre - facet_centre(mould, f)) * n));
          }
        largest = std::max(largest, nearest);
      }
    return largest;
  }
} // namespace

TEST(Mould, every_rubber_face_lies_on_a_facet_that_faces_it)
{
  for (const unsigned int sipes : {0u, 1u, 2u, 3u})
    for (const std::string part : {"whole", "half", "quarter"})
      {
        EXPECT_LT(largest_distance<3>(block_with(sipes, part)), 1e-12);
        EXPECT_LT(largest_distance<2>(block_with(sipes, part)), 1e-12);
      }
}

TEST(Mould, facets_do_not_depend_on_the_rubber_mesh)
{
  TreadBlock         block  = block_with(1, "whole");
  const RigidSurface before = make_mould(block, 3);
  block.element_size        = 0.9;
  block.wall_element_size   = 0.7;
  block.min_elements        = 5;
  const RigidSurface after  = make_mould(block, 3);
  ASSERT_EQ(before.facets.size(), after.facets.size());
  for (std::size_t v = 0; v < before.vertices.size(); ++v)
    EXPECT_EQ(before.vertices[v], after.vertices[v]);

  block.facet_size = 0.5;
  EXPECT_GT(make_mould(block, 3).facets.size(), 2 * before.facets.size());
}

TEST(Mould, whole_mould_is_watertight_up_to_the_land)
{
  // Every edge belongs to two facets, running in opposite directions, but for
  // the outer rim of the land.
  const TreadBlock   block = block_with(2, "whole");
  const RigidSurface mould = make_mould(block, 3);
  std::map<std::pair<unsigned int, unsigned int>, int> n_facets;
  for (const auto &facet : mould.facets)
    for (unsigned int i = 0; i < 4; ++i)
      ++n_facets[{facet.v[i], facet.v[(i + 1) % 4]}];
  for (const auto &[edge, n] : n_facets)
    {
      EXPECT_EQ(n, 1);
      if (n_facets.count({edge.second, edge.first}) == 0)
        {
          EXPECT_NEAR(mould.vertices[edge.first][2], block.height, 1e-12);
          EXPECT_NEAR(mould.vertices[edge.second][2], block.height, 1e-12);
        }
    }
}

TEST(Mould, patches_are_plane_and_count_walls_and_blades)
{
  for (const unsigned int sipes : {0u, 1u, 3u})
    {
      const RigidSurface mould = make_mould(block_with(sipes, "whole"), 3);
      std::map<unsigned int, Tensor<1, 3>> normal_of;
      for (unsigned int f = 0; f < mould.facets.size(); ++f)
        {
          const auto n     = facet_normal(mould, f);
          const auto entry = normal_of.emplace(mould.patch[f], n).first;
          EXPECT_LT((entry->second - n).norm(), 1e-9);
        }
      // Bottom, four walls, land, and three per blade.
      EXPECT_EQ(normal_of.size(), 6 + 3 * sipes);
      EXPECT_GT(normal_of[MouldPatch::bottom][2], 0.999);
      EXPECT_GT(normal_of[MouldPatch::wall + 0][0], 0.99);
      EXPECT_LT(normal_of[MouldPatch::wall + 1][0], -0.99);
      EXPECT_GT(normal_of[MouldPatch::wall + 2][1], 0.99);
      EXPECT_LT(normal_of[MouldPatch::wall + 3][1], -0.99);
      for (unsigned int j = 0; j < sipes; ++j)
        {
          const unsigned int first = MouldPatch::first_blade + 3 * j;
          EXPECT_LT(normal_of[first + MouldPatch::low_flank][0], -0.99);
          EXPECT_GT(normal_of[first + MouldPatch::high_flank][0], 0.99);
          EXPECT_GT(normal_of[first + MouldPatch::blade_end][2], 0.999);
        }
    }
}

TEST(Mould, goes_on_beyond_symmetry_planes_by_one_facet)
{
  for (const unsigned int sipes : {0u, 1u, 2u})
    {
      const TreadBlock   block = block_with(sipes, "quarter");
      const RigidSurface mould = make_mould(block, 3);
      double             low_x = 0, low_y = 0;
      for (const auto &p : mould.vertices)
        {
          low_x = std::min(low_x, p[0]);
          low_y = std::min(low_y, p[1]);
        }
      EXPECT_LT(low_x, -1e-3);
      // Draft widens the facet at the top of the block.
      EXPECT_GT(low_x, -1.2 * block.facet_size);
      EXPECT_LT(low_y, -1e-3);
      EXPECT_GT(low_y, -1.2 * block.facet_size);
    }
}

TEST(Mould, rounded_edges_of_rubber_and_mould_are_one_curve)
{
  // In the slice without draft the edge is a circle: vertices of both sides
  // lie on it, so their distance is at most the height of a chord.
  TreadBlock block        = block_with(0, "whole");
  block.draft_angle       = 0;
  block.corner_radius     = 1.5;
  block.wall_element_size = 0.3;
  const double r          = block.corner_radius;
  const auto   off_circle = [&](const double x, const double y) {
    const double dx = std::abs(x) - (block.length / 2 - r), dy = r - y;
    return dx > 1e-9 && dy > 1e-9 ? std::hypot(dx, dy) - r : 0;
  };
  unsigned int       n_on_edge = 0;
  const RigidSurface mould     = make_mould(block, 2);
  for (const auto &p : mould.vertices)
    {
      EXPECT_NEAR(off_circle(p[0], p[1]), 0, 1e-12);
      n_on_edge +=
        std::abs(p[0]) > block.length / 2 - r + 1e-9 && p[1] < r - 1e-9;
    }
  EXPECT_EQ(n_on_edge, 2u * 15u); // 8 + 8 facets per edge have 15 inner nodes
  Triangulation<2> mesh;
  make_tread_block(block, mesh);
  for (const auto &cell : mesh.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      {
        if (!face->at_boundary())
          continue;
        EXPECT_NEAR(off_circle(face->vertex(0)[0], face->vertex(0)[1]),
                    0,
                    1e-12);
      }
  const auto patches =
    std::set<unsigned int>(mould.patch.begin(), mould.patch.end());
  EXPECT_EQ(patches,
            (std::set<unsigned int>{MouldPatch::bottom, MouldPatch::land}));
}

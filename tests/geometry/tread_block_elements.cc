// SPDX-License-Identifier: LGPL-2.1-or-later
// Elements of the tread block: how many, how fine, and sound at round edges.
#include "geometry/tread_block.h"

#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/boundary_names.h"
#include "geometry/mesh_check.h"
#include "tread_block_closed_form.h"

using namespace demold;
using dealii::Triangulation;

TEST(TreadBlock, lamellae_and_blade_ends_have_the_elements_asked_for)
{
  // Coarse elements: only the least numbers decide. In the slice, a slot end
  // is sipe boundary at the depth, a lamella bottom between two slots.
  for (const unsigned int least : {2u, 4u})
    {
      TreadBlock block        = sharp_block(3);
      block.element_size      = 50;
      block.wall_element_size = 50;
      block.min_elements      = least;
      Triangulation<2> mesh;
      make_tread_block(block, mesh);
      unsigned int ends = 0, lamella = 0, above = 0;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          const auto c = cell->center();
          above += std::abs(c[0] - cell->extent_in_direction(0) / 2) < 1e-9 &&
                   c[1] > block.sipe_depth && c[1] < block.height;
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary())
              {
                const auto f = face->center();
                ends += face->boundary_id() == Boundary::sipe &&
                        std::abs(f[1] - block.sipe_depth) < 1e-9;
                lamella += face->boundary_id() == Boundary::bottom &&
                           f[0] > 0 && f[0] < block.sipe_spacing;
              }
        }
      EXPECT_EQ(ends, 3 * least);
      EXPECT_EQ(lamella, least);
      EXPECT_EQ(above, least);
    }
}

TEST(TreadBlock, elements_are_finest_at_walls_and_never_coarser_than_asked)
{
  TreadBlock block        = sharp_block(0);
  block.draft_angle       = 0;
  block.element_size      = 2;
  block.wall_element_size = 0.25;
  block.growth            = 1.3;
  Triangulation<2> mesh;
  make_tread_block(block, mesh);
  double smallest = 1e9, largest = 0, at_wall = 0;
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int f : {2u, 3u})
      {
        const double dx = cell->face(f)->measure();
        smallest        = std::min(smallest, dx);
        largest         = std::max(largest, dx);
        for (const unsigned int side : {0u, 1u})
          if (cell->face(side)->at_boundary())
            at_wall = std::max(at_wall, dx);
      }
  EXPECT_NEAR(at_wall, smallest, 1e-9);
  // The first element lies between the wall size and its first growth.
  EXPECT_LT(at_wall, block.wall_element_size * block.growth);
  EXPECT_LE(largest, block.element_size * (1 + 1e-9));
  EXPECT_GT(largest, block.element_size / 2);
}

TEST(TreadBlock, rounded_blocks_have_positive_determinants_and_less_volume)
{
  for (const double radius : {0.3, 1., 2.})
    {
      TreadBlock block        = sharp_block(2);
      block.corner_radius     = radius;
      block.draft_angle       = 0;
      block.sipe_draft_angle  = 0;
      block.base_thickness    = 0;
      block.wall_element_size = radius / 8;
      block.element_size      = 1;

      // Four upright edges and four at the bottom lose (1 - pi/4) r^2 per
      // length; the two lower edges along x are interrupted by slots.
      const double     loss = (1 - std::atan(1.)) * radius * radius;
      Triangulation<2> slice;
      make_tread_block(block, slice);
      const double area = 20 * 8 - 2 * 0.6 * 6;
      EXPECT_NEAR(mesh_volume(slice), area - 2 * loss, 0.02 * 2 * loss);

      block.wall_element_size = radius / 4;
      Triangulation<3> mesh; // make_tread_block checks the determinants
      make_tread_block(block, mesh);
      const double uncut = 20 * area;
      const double edges = 4 * 8 + 2 * 20 + 2 * (20 - 2 * 0.6);
      EXPECT_LT(mesh_volume(mesh), uncut);
      // Near the corners edges overlap: at most r per end of an edge.
      EXPECT_NEAR(mesh_volume(mesh),
                  uncut - loss * edges,
                  loss * (0.05 * edges + 12 * radius));
    }
}

TEST(TreadBlock, quarter_with_rounding_and_negative_sipe_draft_is_sound)
{
  TreadBlock block       = sharp_block(3);
  block.corner_radius    = 0.8;
  block.draft_angle      = 5;
  block.sipe_draft_angle = -1;
  Triangulation<3> whole, quarter;
  make_tread_block(block, whole);
  block.symmetry = "quarter";
  make_tread_block(block, quarter);
  EXPECT_NEAR(4 * mesh_volume(quarter), mesh_volume(whole), 1e-8);
}

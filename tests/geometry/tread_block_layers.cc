// SPDX-License-Identifier: LGPL-2.1-or-later
// Layers behind the block have their place, thickness, material and sides.
#include "geometry/tread_block.h"

#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "geometry/boundary_names.h"
#include "geometry/mesh_check.h"
#include "tread_block_closed_form.h"

using namespace demold;
using dealii::Triangulation;

namespace
{
  TreadBlock layered_block()
  {
    TreadBlock block = sharp_block(2);
    block.layers     = {1.2, .8};
    return block;
  }
} // namespace

TEST(TreadBlockLayers, are_boxes_of_their_own_material_behind_the_base)
{
  const TreadBlock block = layered_block();
  Triangulation<3> mesh;
  make_tread_block(block, mesh);
  const double grown = 2 * block.height * ClosedForm(block).t;
  const double area  = (block.length + grown) * (block.width + grown);

  std::map<unsigned int, double> volume;
  for (const auto &cell : mesh.active_cell_iterators())
    {
      volume[cell->material_id()] += cell->measure();
      const double z = cell->center()[2] - block.height - block.base_thickness;
      EXPECT_EQ(cell->material_id(), z < 0 ? 0u : z < 1.2 ? 1u : 2u);
    }
  EXPECT_NEAR(volume[0], ClosedForm(block).volume(), 1e-9 * volume[0]);
  EXPECT_NEAR(volume[1], 1.2 * area, 1e-9 * volume[1]);
  EXPECT_NEAR(volume[2], .8 * area, 1e-9 * volume[2]);
}

TEST(TreadBlockLayers, name_their_sides_and_take_over_the_backing)
{
  const TreadBlock block = layered_block();
  Triangulation<3> mesh;
  make_tread_block(block, mesh);
  const double grown = 2 * block.height * ClosedForm(block).t;
  const double x = block.length + grown, y = block.width + grown;
  EXPECT_NEAR(boundary_area(mesh, Boundary::layer_x), 2 * 2. * y, 1e-9);
  EXPECT_NEAR(boundary_area(mesh, Boundary::layer_y), 2 * 2. * x, 1e-9);
  EXPECT_NEAR(boundary_area(mesh, Boundary::backing), x * y, 1e-9);
  EXPECT_NEAR(boundary_area(mesh, Boundary::free_side),
              2 * (x + y) * block.base_thickness,
              1e-9);
  const double back = block.height + block.base_thickness + 2.;
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == Boundary::backing)
      {
        EXPECT_NEAR(face->center()[2], back, 1e-12);
      }
}

TEST(TreadBlockLayers, leave_the_symmetry_plane_its_name)
{
  TreadBlock block = layered_block();
  block.symmetry   = "half";
  Triangulation<2> mesh;
  make_tread_block(block, mesh);
  EXPECT_NEAR(boundary_area(mesh, Boundary::layer_x), 2., 1e-12);
  EXPECT_NEAR(boundary_area(mesh, Boundary::symmetry_x),
              block.height + block.base_thickness + 2.,
              1e-12);
}

TEST(TreadBlockLayers, do_not_change_the_mould)
{
  TreadBlock block = layered_block();
  for (const int dim : {2, 3})
    {
      const RigidSurface layered = make_mould(block, dim);
      TreadBlock         bare    = block;
      bare.layers.clear();
      const RigidSurface plain = make_mould(bare, dim);
      EXPECT_EQ(layered.vertices, plain.vertices);
      EXPECT_EQ(layered.patch, plain.patch);
    }
}

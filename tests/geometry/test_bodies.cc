// SPDX-License-Identifier: LGPL-2.1-or-later
// Boxes, half cylinders and rigid polylines against their closed forms.
#include "geometry/test_bodies.h"

#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "geometry/boundary_names.h"
#include "geometry/mesh_check.h"

using namespace demold;
using dealii::Point;
using dealii::Tensor;
using dealii::Triangulation;

namespace
{
  const double pi = std::acos(-1.);
}

TEST(Box, names_lie_where_they_should_and_cells_grow_as_asked)
{
  Triangulation<3> mesh;
  make_box<3>({{1, 2, 3}, {{2, 3, 4}}, {{2, 3, 4}}, {{1, 1, 8}}, 5}, mesh);
  EXPECT_EQ(mesh.n_active_cells(), 24u);
  EXPECT_NEAR(mesh_volume(mesh), 24, 1e-12);
  std::map<Boundary::Id, std::pair<unsigned int, double>> plane = {
    {Boundary::left, {0, 1}},
    {Boundary::right, {0, 3}},
    {Boundary::front, {1, 2}},
    {Boundary::back, {1, 5}},
    {Boundary::bottom, {2, 3}},
    {Boundary::top, {2, 7}}};
  for (const auto &cell : mesh.active_cell_iterators())
    {
      EXPECT_EQ(cell->material_id(), 5u);
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            const auto [d, x] = plane.at(face->boundary_id());
            EXPECT_NEAR(face->center()[d], x, 1e-12);
          }
    }
  // Grading 8 over four cells: each twice the one before, 4/15 mm first.
  std::set<long> heights;
  for (const auto &cell : mesh.active_cell_iterators())
    heights.insert(std::lround(1e6 * cell->extent_in_direction(2) * 15 / 4));
  EXPECT_EQ(heights, (std::set<long>{1000000, 2000000, 4000000, 8000000}));
}

TEST(TwoBoxes, bodies_touch_without_sharing_a_vertex)
{
  Triangulation<2> mesh;
  make_two_boxes<2>({{0, 0}, {{2, 1}}, {{3, 2}}},
                    {{-1, -2}, {{4, 2}}, {{5, 2}}},
                    mesh);
  EXPECT_EQ(mesh.n_active_cells(), 6u + 10u);
  EXPECT_EQ(mesh.n_used_vertices(), 4u * 3u + 6u * 3u);
  EXPECT_NEAR(boundary_area(mesh, Boundary::bottom), 2, 1e-12);
  EXPECT_NEAR(boundary_area(mesh, Boundary::base_top), 4, 1e-12);
  EXPECT_NEAR(boundary_area(mesh, Boundary::base_left), 2, 1e-12);
  EXPECT_EQ(boundary_area(mesh, Boundary::unnamed), 0);
  for (const auto &cell : mesh.active_cell_iterators())
    EXPECT_EQ(cell->material_id(), cell->center()[1] > 0 ? 0u : 1u);
}

TEST(Box, irregular_one_keeps_its_volume_and_its_boundary)
{
  Box<3>           box{{0, 0, 0}, {{3, 2, 2}}, {{6, 4, 4}}};
  Triangulation<3> regular, irregular, again;
  make_box<3>(box, regular);
  box.irregularity = 0.2;
  make_box<3>(box, irregular);
  make_box<3>(box, again);
  EXPECT_NEAR(mesh_volume(irregular), 12, 1e-12);
  const auto &before = regular.get_vertices();
  const auto &after  = irregular.get_vertices();
  EXPECT_EQ(after, again.get_vertices());
  double largest = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    {
      bool inside = true;
      for (unsigned int d = 0; d < 3; ++d)
        inside = inside && before[i][d] > 0 && before[i][d] < box.size[d];
      const Tensor<1, 3> shift = after[i] - before[i];
      EXPECT_EQ(shift.norm() > 0, inside);
      for (unsigned int d = 0; d < 3; ++d)
        largest = std::max(largest, std::abs(shift[d]));
    }
  EXPECT_LE(largest, 0.2 * 0.5);
  EXPECT_GT(largest, 0.5 * 0.2 * 0.5);
}

TEST(TwoBoxes, meet_in_the_surface_they_are_mapped_to)
{
  // The plane y = 0 becomes y = x/10; what is 2 mm away stays.
  const auto raised = [](const Point<2> &p) {
    return Point<2>(p[0], p[1] + p[0] / 10 * (1 - std::abs(p[1]) / 2));
  };
  Box<2> upper{{0, 0}, {{2, 2}}, {{3, 2}}}, lower{{0, -2}, {{2, 2}}, {{5, 2}}};
  upper.map = lower.map = raised;
  Triangulation<2> mesh;
  make_two_boxes<2>(upper, lower, mesh);
  EXPECT_NEAR(mesh_volume(mesh), 8, 1e-12);
  const double slope = std::hypot(2, 0.2);
  EXPECT_NEAR(boundary_area(mesh, Boundary::bottom), slope, 1e-12);
  EXPECT_NEAR(boundary_area(mesh, Boundary::base_top), slope, 1e-12);
  EXPECT_NEAR(boundary_area(mesh, Boundary::top), 2, 1e-12);
}

TEST(HalfCylinder, lies_on_a_box_without_sharing_a_vertex)
{
  HalfCylinder     body;
  Triangulation<2> alone, both;
  make_half_cylinder(body, alone);
  make_half_cylinder_on_box(body, {{-5, -2}, {{10, 2}}, {{5, 2}}}, both);
  EXPECT_EQ(both.n_active_cells(), alone.n_active_cells() + 10u);
  EXPECT_EQ(both.n_used_vertices(), alone.n_used_vertices() + 18u);
  EXPECT_NEAR(boundary_area(both, Boundary::base_top), 10, 1e-12);
  EXPECT_NEAR(boundary_area(both, Boundary::bottom),
              boundary_area(alone, Boundary::bottom),
              1e-12);
}

TEST(HalfCylinder, area_of_the_half_disc_converges_with_second_order)
{
  const double exact = pi * 100 / 2;
  double       error[2];
  for (const int i : {0, 1})
    {
      HalfCylinder body;
      body.lowest    = {3, 1};
      body.fine_size = 0.4 / (1 + i);
      body.far_size  = 0.4 / (1 + i);
      Triangulation<2> mesh;
      make_half_cylinder(body, mesh);
      error[i] = exact - mesh_volume(mesh);
      EXPECT_NEAR(boundary_area(mesh, Boundary::top), 20, 1e-9);
      EXPECT_NEAR(boundary_area(mesh, Boundary::bottom), 10 * pi, 0.02);
      EXPECT_EQ(boundary_area(mesh, Boundary::unnamed), 0);
    }
  EXPECT_GT(error[1], 0);
  EXPECT_LT(error[0], 1e-3 * exact);
  EXPECT_NEAR(error[0] / error[1], 4, 0.4);
}

TEST(HalfCylinder, bottom_nodes_lie_on_the_circle_and_are_fine_at_the_contact)
{
  for (const double half_angle : {90., 45.})
    for (const bool right_half : {false, true})
      {
        HalfCylinder body;
        body.half_angle = half_angle;
        body.lowest     = {0, 2};
        body.right_half = right_half;
        Triangulation<2> mesh;
        make_half_cylinder(body, mesh);
        unsigned int n_fine  = 0;
        double       longest = 0;
        for (const auto &cell : mesh.active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && face->boundary_id() == Boundary::bottom)
              {
                EXPECT_NEAR(face->vertex(0).distance({0, 12}), 10, 1e-12);
                longest = std::max(longest, face->measure());
                if (std::abs(face->center()[0]) > 0.9 * body.fine_width)
                  continue;
                ++n_fine;
                EXPECT_LT(face->measure(), 1.05 * body.fine_size);
              }
        EXPECT_GE(n_fine, right_half ? 9u : 18u);
        EXPECT_GT(longest, 2 * body.fine_size);
        EXPECT_EQ(boundary_area(mesh, Boundary::symmetry_x) > 9, right_half);
      }
}

TEST(HalfCylinder, curved_bar_has_the_area_of_its_circular_part)
{
  // Below the level of the centre, |x| < R sin(a): R^2 (a + sin a cos a).
  HalfCylinder body;
  body.half_angle = 60;
  body.fine_size = body.far_size = 0.1;
  Triangulation<2> mesh;
  make_half_cylinder(body, mesh);
  const double a     = pi / 3;
  const double exact = 100 * (a + std::sin(a) * std::cos(a));
  EXPECT_NEAR(mesh_volume(mesh), exact, 1e-4 * exact);
  EXPECT_NEAR(boundary_area(mesh, Boundary::left), 5, 1e-9);
  EXPECT_NEAR(boundary_area(mesh, Boundary::right), 5, 1e-9);
}

TEST(HalfCylinder, fine_zone_may_be_shallower_than_wide)
{
  HalfCylinder body;
  body.fine_width = 2;
  body.fine_depth = 0.4;
  body.right_half = true;
  Triangulation<2> deep, shallow;
  make_half_cylinder(body, shallow);
  body.fine_depth = 0;
  make_half_cylinder(body, deep);
  const auto n_bottom = [](const Triangulation<2> &mesh) {
    unsigned int n = 0;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        n += face->at_boundary() && face->boundary_id() == Boundary::bottom &&
             std::abs(face->center()[0]) < 2;
    return n;
  };
  EXPECT_EQ(n_bottom(shallow), n_bottom(deep));
  EXPECT_LT(shallow.n_active_cells(), deep.n_active_cells());
}

TEST(GradedBox, is_a_rectangle_that_is_fine_where_it_is_asked_to_be)
{
  for (const double centre : {1., 7., 13.})
    {
      GradedBox box;
      box.lower_corner = {1, 2};
      box.size         = {{12, 5}};
      box.fine_centre  = centre;
      box.fine_depth   = 0.4;
      Triangulation<2> mesh;
      make_graded_box(box, mesh);
      EXPECT_NEAR(mesh_volume(mesh), 60, 1e-10);
      for (const auto side : {Boundary::bottom, Boundary::top})
        EXPECT_NEAR(boundary_area(mesh, side), 12, 1e-12);
      for (const auto side : {Boundary::left, Boundary::right})
        EXPECT_NEAR(boundary_area(mesh, side), 5, 1e-12);
      EXPECT_EQ(boundary_area(mesh, Boundary::unnamed), 0);
      double widest = 0;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          const Point<2> c = cell->center();
          widest           = std::max(widest, cell->extent_in_direction(0));
          if (std::abs(c[0] - centre) < box.fine_width)
            {
              EXPECT_LT(cell->extent_in_direction(0), 1.01 * box.fine_size);
            }
          if (c[1] < 2.4)
            {
              EXPECT_LT(cell->extent_in_direction(1), 1.01 * box.fine_size);
            }
        }
      EXPECT_GT(widest, 2 * box.fine_size);
    }
}

TEST(RigidPlane, ground_has_its_area_and_an_upward_normal)
{
  for (const int dim : {2, 3})
    {
      const RigidSurface ground =
        make_rigid_plane({-1, 2}, {4, 5}, -0.5, {{5, 2}}, dim);
      EXPECT_EQ(ground.facets.size(), dim == 2 ? 5u : 10u);
      EXPECT_NEAR(surface_area(ground), dim == 2 ? 5 : 15, 1e-12);
      for (unsigned int f = 0; f < ground.facets.size(); ++f)
        {
          EXPECT_NEAR(facet_normal(ground, f)[dim - 1], 1, 1e-14);
          EXPECT_NEAR(facet_centre(ground, f)[dim - 1], -0.5, 1e-14);
        }
    }
}

TEST(RigidPolyline, step_has_three_patches_and_gentle_bend_has_one)
{
  // A ground at 0 for x > 0 and at 1 for x < 0: the riser looks to +x.
  RigidPolyline step;
  step.corners  = {{3, 0}, {0, 0}, {0, 1}, {-3, 1}};
  step.n_facets = {3, 2, 3};
  for (const int dim : {2, 3})
    {
      const RigidSurface surface = make_rigid_polyline(step, dim);
      ASSERT_EQ(surface.facets.size(), 8u);
      EXPECT_EQ(surface.patch,
                (std::vector<unsigned int>{0, 0, 0, 1, 1, 2, 2, 2}));
      EXPECT_NEAR(facet_normal(surface, 3)[0], 1, 1e-14);
      EXPECT_NEAR(facet_normal(surface, 7)[dim - 1], 1, 1e-14);
    }
  RigidPolyline bend;
  bend.corners  = {{3, 0}, {0, 0}, {-3, 1}};
  bend.n_facets = {1, 1};
  EXPECT_EQ(make_rigid_polyline(bend, 2).patch,
            (std::vector<unsigned int>{0, 0}));
}

TEST(RigidSurface, appended_surfaces_keep_their_facets_and_patches_apart)
{
  RigidSurface       both  = make_rigid_plane({0, 0}, {1, 1}, 0, {{1, 1}}, 3);
  const RigidSurface other = make_rigid_plane({0, 0}, {3, 2}, 4, {{2, 1}}, 3);
  append_surface(both, other);
  EXPECT_NEAR(surface_area(both), 7, 1e-14);
  EXPECT_EQ(both.patch, (std::vector<unsigned int>{0, 1, 1}));
  EXPECT_NEAR(facet_centre(both, 2)[2], 4, 1e-14);
}

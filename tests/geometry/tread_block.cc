// SPDX-License-Identifier: LGPL-2.1-or-later
// The mesh of the tread block has the volume, areas and names of its formula.
#include "geometry/tread_block.h"

#include <deal.II/base/mpi.h>

#include <deal.II/distributed/shared_tria.h>

#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "geometry/boundary_names.h"
#include "geometry/mesh_check.h"
#include "tread_block_closed_form.h"

using namespace demold;
using dealii::Triangulation;

TEST(TreadBlock, whole_block_with_draft_and_sipes_has_the_frustum_s_volume)
{
  for (const unsigned int sipes : {0u, 1u, 2u, 3u})
    {
      TreadBlock block     = sharp_block(sipes);
      block.base_overhang  = sipes == 2 ? 1.25 : 0;
      block.base_thickness = sipes == 1 ? 0 : 1.5;
      Triangulation<3> mesh;
      make_tread_block(block, mesh);
      const double volume = ClosedForm(block).volume();
      EXPECT_NEAR(mesh_volume(mesh), volume, 1e-11 * volume) << sipes;
    }
}

TEST(TreadBlock, every_boundary_face_carries_the_name_of_its_place)
{
  for (const unsigned int sipes : {0u, 1u, 2u, 3u})
    {
      TreadBlock block    = sharp_block(sipes);
      block.base_overhang = 1;
      const ClosedForm form(block);
      Triangulation<3> mesh;
      make_tread_block(block, mesh);
      const double top_x = 22 + 16 * form.t, top_y = 22 + 16 * form.t;
      EXPECT_NEAR(boundary_area(mesh, Boundary::bottom), form.bottom(), 1e-9);
      EXPECT_NEAR(boundary_area(mesh, Boundary::wall), form.walls(), 1e-9);
      EXPECT_NEAR(boundary_area(mesh, Boundary::sipe),
                  form.sipe_surfaces(),
                  1e-9);
      EXPECT_NEAR(boundary_area(mesh, Boundary::groove), form.land(), 1e-9);
      EXPECT_NEAR(boundary_area(mesh, Boundary::backing), top_x * top_y, 1e-9);
      EXPECT_NEAR(boundary_area(mesh, Boundary::free_side),
                  2 * (top_x + top_y) * block.base_thickness,
                  1e-9);
      for (const Boundary::Id id : {Boundary::unnamed,
                                    Boundary::symmetry_x,
                                    Boundary::symmetry_y,
                                    Boundary::left})
        EXPECT_EQ(boundary_area(mesh, id), 0) << boundary_name(id);
    }
}

TEST(TreadBlock, halves_and_quarters_are_exact_parts_of_the_whole)
{
  for (const unsigned int sipes : {0u, 1u, 2u, 3u})
    {
      TreadBlock       block = sharp_block(sipes);
      const ClosedForm form(block);
      Triangulation<3> whole;
      make_tread_block(block, whole);
      for (const std::string part : {"half", "half y", "quarter"})
        {
          block.symmetry           = part;
          const unsigned int times = block.symmetry_factor(3);
          EXPECT_EQ(times, part == "quarter" ? 4u : 2u);
          Triangulation<3> mesh;
          make_tread_block(block, mesh);
          EXPECT_EQ(times * mesh.n_active_cells(), whole.n_active_cells());
          EXPECT_NEAR(times * mesh_volume(mesh), form.volume(), 1e-8);
          EXPECT_NEAR(times * boundary_area(mesh, Boundary::sipe),
                      form.sipe_surfaces(),
                      1e-9);
          EXPECT_NEAR(times * boundary_area(mesh, Boundary::wall),
                      form.walls(),
                      1e-9);

          // The cut through the block at x = 0 is a trapezoid and the base,
          // less the middle slot.
          const double slot =
            sipes % 2 == 1 ?
              block.sipe_depth * (block.width + block.sipe_depth * form.t) :
              0;
          const double cut =
            block.height * (block.width + block.height * form.t) +
            block.base_thickness * (block.width + 2 * block.height * form.t) -
            slot;
          const double share = part == "half" ? 1 : part == "half y" ? 0 : 0.5;
          EXPECT_NEAR(boundary_area(mesh, Boundary::symmetry_x),
                      share * cut,
                      1e-9);
          EXPECT_EQ(boundary_area(mesh, Boundary::symmetry_y) > 0,
                    part != "half");
        }
    }
}

TEST(TreadBlock, a_slice_has_the_areas_of_the_cut_at_y_zero)
{
  for (const unsigned int sipes : {0u, 1u, 2u, 3u})
    for (const std::string part : {"whole", "half", "half y", "quarter"})
      {
        TreadBlock block = sharp_block(sipes);
        block.symmetry   = part;
        const ClosedForm form(block);
        const double     times = block.symmetry_factor(2);
        EXPECT_EQ(times, part == "half" || part == "quarter" ? 2 : 1);
        const double top = block.length + 2 * block.height * form.t;
        const double end = block.sipe_thickness - 2 * block.sipe_depth * form.s;
        Triangulation<2> mesh;
        make_tread_block(block, mesh);
        EXPECT_NEAR(times * mesh_volume(mesh),
                    block.height * (block.length + top) / 2 +
                      block.base_thickness * top -
                      sipes * block.sipe_depth * (block.sipe_thickness + end) /
                        2,
                    1e-9);
        EXPECT_NEAR(times * boundary_area(mesh, Boundary::bottom),
                    block.length - sipes * block.sipe_thickness,
                    1e-10);
        EXPECT_NEAR(times * boundary_area(mesh, Boundary::wall),
                    2 * block.height * std::sqrt(1 + form.t * form.t),
                    1e-10);
        EXPECT_NEAR(times * boundary_area(mesh, Boundary::sipe),
                    sipes * (end + 2 * block.sipe_depth *
                                     std::sqrt(1 + form.s * form.s)),
                    1e-10);
        EXPECT_EQ(boundary_area(mesh, Boundary::unnamed), 0);
      }
}

TEST(TreadBlock, a_block_without_draft_has_the_contact_area_of_the_scenario)
{
  // Theory F: 400 + 640 + 280 n mm^2, which leaves the mouths of the slots in
  // the walls in place: 2 x 7 mm x thickness each.
  for (const unsigned int sipes : {0u, 1u, 4u})
    {
      TreadBlock block       = sharp_block(sipes);
      block.draft_angle      = 0;
      block.sipe_draft_angle = 0;
      block.sipe_depth       = 7;
      block.sipe_spacing     = 4;
      EXPECT_NEAR(contact_area(block, 3),
                  400 + 640 + 280. * sipes -
                    2 * 7 * block.sipe_thickness * sipes,
                  1e-9);
    }
}

TEST(TreadBlock, contact_area_is_that_of_the_whole_block_for_every_part)
{
  for (const unsigned int sipes : {1u, 2u})
    for (const std::string part : {"whole", "half", "half y", "quarter"})
      {
        TreadBlock block    = sharp_block(sipes);
        block.base_overhang = 0.5;
        block.symmetry      = part;
        EXPECT_NEAR(contact_area(block, 3), ClosedForm(block).contact(), 1e-9);
      }
}

TEST(TreadBlock, a_shared_triangulation_takes_the_same_mesh)
{
  if (!dealii::Utilities::MPI::job_supports_mpi())
    {
      static char                                     name[]  = "geometry";
      static char                                    *words[] = {name, nullptr};
      static int                                      n       = 1;
      static char                                   **argv    = words;
      static dealii::Utilities::MPI::MPI_InitFinalize mpi(n, argv, 1);
    }
  const TreadBlock                           block = sharp_block(1);
  dealii::parallel::shared::Triangulation<3> mesh(
    MPI_COMM_SELF,
    dealii::Triangulation<3>::none,
    true,
    dealii::parallel::shared::Triangulation<3>::partition_metis);
  make_tread_block(block, mesh);
  const ClosedForm form(block);
  EXPECT_NEAR(mesh_volume<3>(mesh), form.volume(), 1e-8);
  EXPECT_NEAR(boundary_area<3>(mesh, Boundary::sipe),
              form.sipe_surfaces(),
              1e-9);
}

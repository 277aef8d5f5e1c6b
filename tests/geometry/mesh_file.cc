// SPDX-License-Identifier: LGPL-2.1-or-later
// Gmsh files are read as they are or refused with the reason.
#include "geometry/mesh_file.h"

#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/parameter_error.h"
#include "geometry/boundary_names.h"
#include "geometry/mesh_check.h"

using namespace demold;
using dealii::Triangulation;

namespace
{
  const double slope = std::tan(3 * std::acos(-1.) / 180);

  std::string shipped(const std::string &name)
  {
    return DEMOLD_SOURCE_DIR "/prm/step-demold/meshes/" + name;
  }

  // A file that lives as long as the object.
  struct TemporaryFile
  {
    explicit TemporaryFile(const std::string &text)
    {
      const auto *test = testing::UnitTest::GetInstance()->current_test_info();
      name =
        testing::TempDir() + test->name() + std::to_string(number++) + ".msh";
      std::ofstream(name) << text;
    }
    ~TemporaryFile()
    {
      std::filesystem::remove(name);
    }
    std::string       name;
    inline static int number = 0;
  };

  template <int dim>
  std::string refusal(const std::string &file)
  {
    try
      {
        Triangulation<dim> mesh;
        read_mesh_file(file, mesh);
      }
    catch (const ExcParameter &error)
      {
        return error.what();
      }
    return "accepted";
  }

  void expect_words(const std::string              &text,
                    const std::vector<std::string> &words)
  {
    for (const std::string &word : words)
      EXPECT_NE(text.find(word), std::string::npos)
        << '"' << word << "\" is missing in: " << text;
  }

  // Two unit squares side by side and their boundary, format 2.2. The second
  // cell's nodes can be replaced.
  std::string two_squares(const std::string &second_cell = "8 3 2 1 1 2 3 6 5",
                          const std::string &last_edge   = "6 1 2 8 1 4 1")
  {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n"
           "1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n"
           "$Elements\n8\n"
           "1 1 2 3 1 1 2\n2 1 2 3 1 2 3\n3 1 2 8 1 3 6\n4 1 2 7 1 6 5\n"
           "5 1 2 7 1 5 4\n" +
           last_edge + "\n7 3 2 1 1 1 2 5 4\n" + second_cell +
           "\n$EndElements\n";
  }

  std::string text_of(const std::string &file)
  {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }
} // namespace

TEST(MeshFile, shipped_block_has_the_volume_and_areas_of_its_geo_file)
{
  Triangulation<3> mesh;
  read_mesh_file(shipped("small-block.msh"), mesh);
  const double top = 6 + 8 * slope;
  EXPECT_NEAR(mesh_volume(mesh), 4. / 3 * (36 + 6 * top + top * top), 1e-9);
  EXPECT_NEAR(boundary_area(mesh, Boundary::bottom), 36, 1e-9);
  EXPECT_NEAR(boundary_area(mesh, Boundary::backing), top * top, 1e-9);
  EXPECT_NEAR(boundary_area(mesh, Boundary::wall),
              4 * (6 + top) / 2 * 4 * std::sqrt(1 + slope * slope),
              1e-9);
  for (const auto &cell : mesh.active_cell_iterators())
    EXPECT_EQ(cell->material_id(), 1u);
}

TEST(MeshFile, shipped_mould_faces_the_rubber_with_a_patch_per_plane)
{
  const RigidSurface mould = read_rigid_surface(shipped("small-mould.msh"), 3);
  const double       top   = 6 + 8 * slope;
  EXPECT_NEAR(surface_area(mould),
              36 + 4 * (6 + top) / 2 * 4 * std::sqrt(1 + slope * slope),
              1e-9);
  for (unsigned int f = 0; f < mould.facets.size(); ++f)
    {
      // The middle of the rubber is in front of every facet.
      const dealii::Point<3> middle(0, 0, 2);
      EXPECT_GT((middle - facet_centre(mould, f)) * facet_normal(mould, f),
                1.9);
    }
  EXPECT_EQ(std::set<unsigned int>(mould.patch.begin(), mould.patch.end()),
            (std::set<unsigned int>{1, 2, 3, 4, 5}));
}

TEST(MeshFile, squares_of_format_two_are_read_with_their_groups)
{
  const TemporaryFile file(two_squares());
  Triangulation<2>    mesh;
  read_mesh_file(file.name, mesh);
  EXPECT_NEAR(mesh_volume(mesh), 2, 1e-14);
  EXPECT_NEAR(boundary_area(mesh, Boundary::bottom), 2, 1e-14);
  EXPECT_NEAR(boundary_area(mesh, Boundary::backing), 2, 1e-14);
  EXPECT_NEAR(boundary_area(mesh, Boundary::wall), 2, 1e-14);
}

TEST(MeshFile, lines_become_facets_with_the_normal_on_their_right)
{
  // A valley walked from right to left and up: metal below and on the left.
  const std::string head =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 1 0\n2 0 0 0\n"
    "3 2 0 0\n9 7 7 0\n$EndNodes\n$Elements\n2\n";
  const TemporaryFile file(head +
                           "1 1 2 4 1 3 2\n2 1 2 5 1 2 1\n$EndElements\n");
  const RigidSurface  mould = read_rigid_surface(file.name, 2);
  ASSERT_EQ(mould.facets.size(), 2u);
  EXPECT_EQ(mould.vertices.size(), 3u); // node 9 is on no line
  EXPECT_NEAR(facet_normal(mould, 0)[1], 1, 1e-14);
  EXPECT_NEAR(facet_normal(mould, 1)[0], 1, 1e-14);
  EXPECT_EQ(mould.patch, (std::vector<unsigned int>{4, 5}));

  const TemporaryFile point(head + "1 1 2 4 1 3 2\n2 1 2 5 1 2 2\n"
                                   "$EndElements\n");
  try
    {
      read_rigid_surface(point.name, 2);
      FAIL();
    }
  catch (const ExcParameter &error)
    {
      expect_words(error.what(), {"Mould/mesh file: ", "element 2", "above 0"});
    }
}

TEST(MeshFile, a_mesh_of_the_rubber_is_refused_as_mould)
{
  // Its boundary would look out of the rubber instead of into it.
  EXPECT_THROW(read_rigid_surface(shipped("small-block.msh"), 3), ExcParameter);
}

TEST(MeshFile, triangles_and_tetrahedra_are_refused_by_name)
{
  const TemporaryFile triangle(two_squares("8 2 2 1 1 2 3 6"));
  expect_words(refusal<2>(triangle.name),
               {"Block/mesh file: ", "element 8 is a triangle", "Recombine"});
  const TemporaryFile tetrahedron(two_squares("8 4 2 1 1 1 2 3 4"));
  expect_words(refusal<3>(tetrahedron.name),
               {"Block/mesh file: ", "element 8 is a tetrahedron"});
  const TemporaryFile second_order(two_squares("8 16 2 1 1 1 2 3 4 5 6 1 2"));
  expect_words(refusal<2>(second_order.name),
               {"quadrilateral of second order", "ElementOrder = 1"});
  const TemporaryFile plane(two_squares());
  expect_words(refusal<3>(plane.name), {"no hexahedron cells"});
}

TEST(MeshFile, folded_cells_are_refused_by_number_place_and_determinant)
{
  // Nodes 6 and 5 exchanged: a bow tie around (1.5, 0.5).
  const TemporaryFile bow_tie(two_squares("8 3 2 1 1 2 3 5 6"));
  expect_words(refusal<2>(bow_tie.name),
               {"Block/mesh file: ", "element 8 around (1.5 0.5)", "-1"});
  // One cell of two listed the other way round.
  const TemporaryFile turned(two_squares("8 3 2 1 1 2 5 6 3"));
  expect_words(refusal<2>(turned.name), {"element 8", "falls to -1"});
}

TEST(MeshFile, boundary_faces_without_a_group_are_refused_with_their_number)
{
  const TemporaryFile file(two_squares("8 3 2 1 1 2 3 6 5", "6 15 2 0 1 4"));
  expect_words(refusal<2>(file.name),
               {"Block/mesh file: ", "1 of 6", "0 0.5", "Physical Curve"});
}

TEST(MeshFile, missing_and_broken_files_are_refused_with_what_is_wrong)
{
  expect_words(refusal<3>("no-such-file.msh"),
               {"Block/mesh file: ", "no-such-file.msh", "cannot be opened"});
  const TemporaryFile empty("");
  expect_words(refusal<3>(empty.name), {"no section $Nodes"});
  const TemporaryFile prose("this is no mesh");
  expect_words(refusal<3>(prose.name), {"'this'", "$Nodes"});
  const TemporaryFile binary("$MeshFormat\n4.1 1 8\n");
  expect_words(refusal<3>(binary.name), {"binary", "ASCII"});
  const TemporaryFile old("$MeshFormat\n1.0 0 8\n$EndMeshFormat\n");
  expect_words(refusal<3>(old.name), {"format 1.0", "4.1"});
  std::string one_less = two_squares();
  one_less.replace(one_less.find("$Elements\n8"), 11, "$Elements\n7");
  const TemporaryFile more(one_less);
  expect_words(refusal<2>(more.name), {"'8'", "$EndElements", "announced"});
  const TemporaryFile stranger(two_squares("8 3 2 1 1 2 3 6 55"));
  expect_words(refusal<2>(stranger.name), {"element 8 with node 55"});
}

TEST(MeshFile, a_file_cut_off_anywhere_is_refused_and_never_read_in_part)
{
  const std::string text = text_of(shipped("small-block.msh"));
  ASSERT_GT(text.size(), 1000u);
  const std::string end = "$EndElements";
  for (std::size_t length = 0; length < text.rfind(end) + end.size();
       length += 997)
    {
      const TemporaryFile file(text.substr(0, length));
      expect_words(refusal<3>(file.name), {"Block/mesh file: "});
    }
}

TEST(MeshFile, a_mesh_without_its_mould_is_refused)
{
  MeshFiles files;
  files.check(3);
  files.block = shipped("small-block.msh");
  EXPECT_THROW(files.check(3), ExcParameter);
  files.mould = shipped("small-mould.msh");
  files.check(3);
  files.block.clear();
  EXPECT_THROW(files.check(3), ExcParameter);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks a Gmsh file, then hands it to deal.II or makes facets of it.
#include "geometry/mesh_file.h"

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "base/parameter_error.h"
#include "geometry/boundary_names.h"
#include "geometry/mesh_check.h"
#include "geometry/msh_content.h"

namespace demold
{
  using namespace dealii;

  namespace
  {
    // Lower-dimensional elements only name the boundary.
    void check_types(const MshContent  &content,
                     const unsigned int cell_type,
                     const std::string &file,
                     const std::string &path)
    {
      unsigned int n_cells = 0;
      for (const MshElement &element : content.elements)
        {
          n_cells += (element.type == cell_type);
          if (element.type == cell_type || element.type == MshType::point ||
              element.type == MshType::line ||
              (element.type == MshType::quadrilateral &&
               cell_type == MshType::hexahedron))
            continue;
          throw ExcParameter(
            path,
            "the file '" + file + "' must hold " + msh_type_name(cell_type) +
              " cells (type " + std::to_string(cell_type) +
              ") of first order; element " + std::to_string(element.number) +
              " is a " + msh_type_name(element.type) + " (type " +
              std::to_string(element.type) +
              "). In Gmsh use transfinite shapes or extrusions with Recombine, "
              "Mesh.ElementOrder = 1, and leave physical groups of other "
              "dimensions out.");
        }
      if (n_cells == 0)
        throw ExcParameter(path,
                           "the file '" + file + "' has no " +
                             msh_type_name(cell_type) +
                             " cells. If the volume has no physical group, "
                             "Gmsh leaves its cells out.");
    }

    template <int dim>
    CellCorners<dim> corners_of(const MshContent &content,
                                const MshElement &element)
    {
      // Gmsh runs around the faces, deal.II counts lexicographically.
      constexpr std::array<unsigned int, 8> gmsh = {{0, 1, 3, 2, 4, 5, 7, 6}};
      CellCorners<dim>                      corners;
      for (unsigned int v = 0; v < corners.size(); ++v)
        for (unsigned int d = 0; d < dim; ++d)
          corners[v][d] = content.points[element.nodes[gmsh[v]]][d];
      return corners;
    }

    template <int dim>
    Point<dim> unit_centre()
    {
      Point<dim> centre;
      for (unsigned int d = 0; d < dim; ++d)
        centre[d] = 0.5;
      return centre;
    }

    // A mesh that is left-handed throughout is only listed the other way
    // round (deal.II turns it); a single such cell is a mistake.
    template <int dim>
    void check_shapes(const MshContent  &content,
                      const unsigned int cell_type,
                      const std::string &file,
                      const std::string &path)
    {
      bool all_left_handed = true;
      for (const MshElement &element : content.elements)
        if (element.type == cell_type &&
            jacobian<dim>(corners_of<dim>(content, element),
                          unit_centre<dim>()) > 0)
          all_left_handed = false;

      for (const MshElement &element : content.elements)
        {
          if (element.type != cell_type)
            continue;
          CellCorners<dim> corners = corners_of<dim>(content, element);
          if (all_left_handed)
            for (unsigned int v = 0; v < corners.size(); v += 2)
              std::swap(corners[v], corners[v + 1]);
          const double smallest = smallest_jacobian<dim>(corners);
          if (smallest > 0)
            continue;
          Point<dim> centre;
          for (const Point<dim> &corner : corners)
            centre += corner / double(corners.size());
          std::ostringstream text;
          text << "the file '" << file << "' has a folded or flat cell: "
               << "element " << element.number << " around (" << centre
               << ") mm; the determinant of its map must be above 0 mm^" << dim
               << " everywhere; it falls to " << smallest
               << ". Its nodes are in a wrong order or one lies on the wrong "
                  "side.";
          throw ExcParameter(path, text.str());
        }
    }

    void check_flat(const MshContent  &content,
                    const std::string &file,
                    const std::string &path)
    {
      for (const Point<3> &p : content.points)
        if (std::abs(p[2]) > 1e-8)
          throw ExcParameter(path,
                             "the file '" + file +
                               "' must lie in the plane z = 0 mm for a 2-D "
                               "scene; it has a node at z = " +
                               std::to_string(p[2]) + " mm.");
    }

    template <int dim>
    void check_names(const Triangulation<dim, dim> &triangulation,
                     const std::string             &file,
                     const std::string             &path)
    {
      unsigned int       n_faces = 0, n_unnamed = 0;
      std::ostringstream where;
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            {
              ++n_faces;
              if (face->boundary_id() != Boundary::unnamed)
                continue;
              if (n_unnamed++ == 0)
                where << face->center();
            }
      if (n_unnamed > 0)
        throw ExcParameter(
          path,
          "in the file '" + file +
            "' all boundary faces must be in a physical group; " +
            std::to_string(n_unnamed) + " of " + std::to_string(n_faces) +
            " are not, for example around (" + where.str() +
            ") mm. In Gmsh add Physical Surface (3-D) or Physical Curve "
            "(2-D), with the numbers of the boundary names.");
    }
  } // namespace

  void MeshFiles::add_parameters(ParameterHandler &prm)
  {
    const auto declare = [&](const std::string &section,
                             std::string       &name,
                             const std::string &what) {
      prm.enter_subsection(section);
      prm.add_parameter("mesh file",
                        name,
                        what + ", Gmsh format 2.2 or 4.1, ASCII, in mm; "
                               "empty: the built-in shape [-]",
                        Patterns::Anything());
      prm.leave_subsection();
    };
    declare("Block", block, "mesh of the rubber");
    declare("Mould", mould, "facets of the mould, normals into the rubber");
  }

  void MeshFiles::check(const int dim) const
  {
    if (!block.empty() && mould.empty())
      throw ExcParameter("Mould/mesh file",
                         "must be given with Block/mesh file = '" + block +
                           "'; it is empty.");
    if (block.empty() && !mould.empty())
      throw ExcParameter("Block/mesh file",
                         "must be given with Mould/mesh file = '" + mould +
                           "'; it is empty.");
    if (block.empty())
      return;
    if (dim == 3)
      {
        Triangulation<3> triangulation;
        read_mesh_file(block, triangulation);
      }
    else
      {
        Triangulation<2> triangulation;
        read_mesh_file(block, triangulation);
      }
    read_rigid_surface(mould, dim);
  }

  template <int dim>
  void read_mesh_file(const std::string       &file,
                      Triangulation<dim, dim> &triangulation,
                      const std::string       &path)
  {
    const unsigned int cell_type =
      dim == 3 ? MshType::hexahedron : MshType::quadrilateral;
    const MshContent content = read_msh_content(file, path);
    check_types(content, cell_type, file, path);
    if (dim == 2)
      check_flat(content, file, path);
    check_shapes<dim>(content, cell_type, file, path);

    try
      {
        std::ifstream in(file);
        GridIn<dim>   grid_in(triangulation);
        grid_in.read_msh(in);
      }
    catch (const ExceptionBase &error)
      {
        std::ostringstream what;
        error.print_info(what);
        throw ExcParameter(path,
                           "the file '" + file +
                             "' was refused by the mesh reader: " + what.str());
      }
    check_names(triangulation, file, path);
    check_cells(triangulation, path);
  }

  RigidSurface read_rigid_surface(const std::string &file,
                                  const int          dim,
                                  const std::string &path)
  {
    const unsigned int facet_type =
      dim == 3 ? MshType::quadrilateral : MshType::line;
    const MshContent content = read_msh_content(file, path);
    check_types(content, facet_type, file, path);
    if (dim == 2)
      check_flat(content, file, path);

    RigidSurface                         surface;
    std::map<unsigned int, unsigned int> index_of;
    for (const MshElement &element : content.elements)
      {
        if (element.type != facet_type)
          continue;
        RigidSurface::Facet facet{{}, 0};
        for (const unsigned int node : element.nodes)
          {
            const auto [entry, is_new] =
              index_of.emplace(node, surface.vertices.size());
            if (is_new)
              surface.vertices.push_back(content.points[node]);
            facet.v[facet.n++] = entry->second;
          }
        surface.facets.push_back(facet);
        surface.patch.push_back(std::max(0, element.physical));
        if (!(facet_area(surface, surface.facets.size() - 1) > 0))
          throw ExcParameter(path,
                             "in the file '" + file +
                               "' the facet of element " +
                               std::to_string(element.number) +
                               " must have an area above 0; it has none.");
      }
    return surface;
  }

  template void read_mesh_file(const std::string &,
                               Triangulation<2, 2> &,
                               const std::string &);
  template void read_mesh_file(const std::string &,
                               Triangulation<3, 3> &,
                               const std::string &);
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Rubber and mould from Gmsh files instead of the built-in block.
#ifndef demold_geometry_mesh_file_h
#define demold_geometry_mesh_file_h

#include <string>

#include "geometry/rigid_surface.h"

namespace dealii
{
  class ParameterHandler;
  template <int dim, int spacedim>
  class Triangulation;
} // namespace dealii

namespace demold
{
  /// The entries "Block/mesh file" and "Mould/mesh file"; empty names mean
  /// the built-in block and its mould.
  struct MeshFiles
  {
    std::string block;
    std::string mould;

    void add_parameters(dealii::ParameterHandler &prm);

    /// Throw ExcParameter if a mesh is given without its mould, or the
    /// reverse, or a file cannot be used.
    void check(int dim) const;
  };

  /// Read hexahedra (3-D) or quadrilaterals in the x-y plane (2-D) from an
  /// ASCII .msh file of version 2.2 or 4.1 into an empty triangulation.
  /// Coordinates in mm. Physical groups of the volume become material ids,
  /// those of the boundary become boundary ids: use the numbers of
  /// boundary_names.h (bottom 3, backing 7, wall 8, sipe 9 ...). Every
  /// boundary face must be in a physical group.
  ///
  /// Throws ExcParameter(@p path, ...) for files that are missing or broken,
  /// other cells (tetrahedra ...), second order, folded cells (names the
  /// element and its determinant), faces without a group.
  template <int dim>
  void read_mesh_file(const std::string               &file,
                      dealii::Triangulation<dim, dim> &triangulation,
                      const std::string &path = "Block/mesh file");

  /// Read the mould as quadrilaterals (@p dim = 3) or lines in the x-y plane
  /// (@p dim = 2) of a .msh file. The order of nodes in the file is the
  /// orientation: the normal must point out of the metal, into the rubber,
  /// as in rigid_surface.h (Gmsh's own surface normal in 3-D; in 2-D the
  /// metal is on the left of a line). The physical group is the number of
  /// the smooth patch. Throws as read_mesh_file.
  RigidSurface read_rigid_surface(const std::string &file,
                                  int                dim,
                                  const std::string &path = "Mould/mesh file");
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// What a Gmsh file says, checked, before anything is made of it.
#ifndef demold_geometry_msh_content_h
#define demold_geometry_msh_content_h

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace demold
{
  /// Gmsh's numbers of element types used here.
  struct MshType
  {
    static constexpr unsigned int line          = 1;
    static constexpr unsigned int quadrilateral = 3;
    static constexpr unsigned int hexahedron    = 5;
    static constexpr unsigned int point         = 15;
  };

  struct MshElement
  {
    /// Number in the file and element type.
    unsigned int number;
    unsigned int type;
    /// Physical group, 0 if none.
    int physical;
    /// Indices into MshContent::points, in Gmsh's order.
    std::vector<unsigned int> nodes;
  };

  struct MshContent
  {
    std::vector<dealii::Point<3>> points; // [mm]
    std::vector<MshElement>       elements;
  };

  /// Read an ASCII .msh file of version 2 or 4.1. A file that is missing,
  /// binary, cut off or inconsistent throws ExcParameter(@p path, ...) with
  /// what is wrong.
  MshContent read_msh_content(const std::string &file, const std::string &path);

  /// "hexahedron" for 5, and so on.
  std::string msh_type_name(unsigned int type);
} // namespace demold

#endif

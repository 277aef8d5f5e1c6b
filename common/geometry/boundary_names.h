// SPDX-License-Identifier: LGPL-2.1-or-later
// The one list of boundary ids and the names they have in prm files.
#ifndef demold_geometry_boundary_names_h
#define demold_geometry_boundary_names_h

#include <deal.II/base/types.h>

#include <string>
#include <vector>

namespace demold
{
  /// Ids of boundary parts; 0 is left to faces nobody has named. The same
  /// numbers are the physical groups of Gmsh files.
  struct Boundary
  {
    using Id = dealii::types::boundary_id;

    /// A face nobody has named (deal.II's default).
    static constexpr Id unnamed = 0;

    // Boxes. The vertical is y in 2-D and z in 3-D; front and back are the
    // faces of smallest and largest y in 3-D.
    static constexpr Id left   = 1;
    static constexpr Id right  = 2;
    static constexpr Id bottom = 3; // also the tread surface of the block
    static constexpr Id top    = 4;
    static constexpr Id front  = 5;
    static constexpr Id back   = 6;

    // Tread block.
    static constexpr Id backing    = 7;  // held, opposite to the bottom
    static constexpr Id wall       = 8;  // outer flanks in the mould
    static constexpr Id sipe       = 9;  // flanks and ends of the slots
    static constexpr Id groove     = 10; // base rubber beside the block
    static constexpr Id free_side  = 11; // sides of the base rubber
    static constexpr Id symmetry_x = 12; // plane x = 0
    static constexpr Id symmetry_y = 13; // plane y = 0
    static constexpr Id layer_x    = 14; // sides, normal to x, of layers
    static constexpr Id layer_y    = 15; // the same, normal to y

    // The lower body of two bodies: box id + base_offset.
    static constexpr Id base_offset = 20;
    static constexpr Id base_left   = base_offset + left;
    static constexpr Id base_right  = base_offset + right;
    static constexpr Id base_bottom = base_offset + bottom;
    static constexpr Id base_top    = base_offset + top;
    static constexpr Id base_front  = base_offset + front;
    static constexpr Id base_back   = base_offset + back;
  };

  /// All ids that have a name, ascending.
  std::vector<Boundary::Id> named_boundaries();

  /// Name as in prm files, for example "symmetry x"; "boundary 17" for an id
  /// without a name.
  std::string boundary_name(Boundary::Id id);

  /// Id of a name as in prm files; a whole number is taken as the id itself
  /// (physical groups of mesh files). An unknown name throws ExcParameter
  /// with @p path and the nearest name.
  Boundary::Id boundary_id(const std::string &name, const std::string &path);
} // namespace demold

#endif

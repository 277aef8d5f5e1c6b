// SPDX-License-Identifier: LGPL-2.1-or-later
// A projected face as one convex quadrilateral or as triangles.
#ifndef demold_mortar_convex_cells_h
#define demold_mortar_convex_cells_h

#include "mortar/plane_vector.h"

#include <array>

namespace demold
{
  /// A convex piece of a projected face: some of its nodes, counter-clockwise
  /// in the auxiliary plane. Four nodes are interpolated bilinearly, three
  /// linearly; bilinear functions do not depend on where the numbering starts
  /// and which way it runs.
  struct ConvexCell
  {
    std::array<unsigned int, 4> nodes{};
    unsigned int                n_nodes = 0; ///< 3 or 4
  };

  struct ConvexCells
  {
    std::array<ConvexCell, 2> cells;
    unsigned int              n_cells = 0;
  };

  /// Signed area [mm^2] of a projected quadrilateral.
  double signed_area(const PlaneNodes<double> &y);

  /// The cells of a projected quadrilateral: itself if convex, else its two
  /// triangles at the diagonal through the re-entrant corner. Of a
  /// quadrilateral that crosses itself only the triangles that turn the same
  /// way as the whole are kept. None if it has no area.
  ConvexCells convex_cells(const PlaneNodes<double> &y);
} // namespace demold

#endif

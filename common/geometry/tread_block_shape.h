// SPDX-License-Identifier: LGPL-2.1-or-later
// Where rubber and mould of a tread block agree: lines, slots, draft, rounding.
#ifndef demold_geometry_tread_block_shape_h
#define demold_geometry_tread_block_shape_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

#include "geometry/structured_grid.h"
#include "geometry/tread_block.h"

namespace demold
{
  /// Maps the upright block (no draft, sharp edges, slots of constant
  /// thickness) to the real one: first the rounding of edges, then the draft.
  /// Always 3-D; a 2-D slice is y = 0. All lengths in mm.
  class BlockShape
  {
  public:
    explicit BlockShape(const TreadBlock &block);

    /// Half of the block's extents in x and y at height z (constant above H).
    double half_length(double z) const;
    double half_width(double z) const;

    /// Half of the slot's width at height z (constant above its end).
    double half_slot(double z) const;

    /// Middles of the slots with x >= 0, ascending.
    const std::vector<double> &slots() const;

    dealii::Point<3> operator()(const dealii::Point<3> &upright) const;

  private:
    dealii::Point<3> round_edges(const dealii::Point<3> &p) const;

    double drafted_x(double x, double z) const;

    TreadBlock          block;
    std::vector<double> slot_middles;
  };

  /// Kinds of cells along x and y, and along the vertical.
  struct BlockPart
  {
    static constexpr unsigned int lamella  = 0;
    static constexpr unsigned int slot     = 1;
    static constexpr unsigned int overhang = 2;

    static constexpr unsigned int beside_blade = 0;
    static constexpr unsigned int above_blade  = 1;
    static constexpr unsigned int base         = 2;
    static constexpr unsigned int first_layer  = 3; // and on, one number each
  };

  /// Lines of the upright block for the rubber mesh, symmetric parts only.
  template <int dim>
  std::array<GridAxis, dim> rubber_axes(const TreadBlock &block);

  /// The same for the facets of the mould, all of one size.
  template <int dim>
  std::array<GridAxis, dim> mould_axes(const TreadBlock &block);

  /// Product of the numbers of cells.
  template <std::size_t n_axes>
  double n_grid_cells(const std::array<GridAxis, n_axes> &axes)
  {
    double n = 1;
    for (const GridAxis &axis : axes)
      n *= axis.n_cells();
    return n;
  }

  /// The block's cells on these lines: which exist, names of their faces, and
  /// their true positions.
  template <int dim>
  StructuredGrid<dim> block_grid(const TreadBlock                &block,
                                 const std::array<GridAxis, dim> &axes);
} // namespace demold

#endif

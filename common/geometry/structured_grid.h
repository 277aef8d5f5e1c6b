// SPDX-License-Identifier: LGPL-2.1-or-later
// Structured grids with cells left out: lines along axes, mapped afterwards.
#ifndef demold_geometry_structured_grid_h
#define demold_geometry_structured_grid_h

#include <deal.II/base/point.h>

#include <deal.II/grid/tria_description.h>

#include <array>
#include <functional>
#include <vector>

#include "geometry/boundary_names.h"

namespace dealii
{
  template <int dim, int spacedim>
  class Triangulation;
}

namespace demold
{
  /// Ascending lines along one direction [mm] and a number per cell between
  /// them that says what the cell belongs to.
  struct GridAxis
  {
    std::vector<double>       lines;
    std::vector<unsigned int> kinds;

    unsigned int n_cells() const
    {
      return static_cast<unsigned int>(kinds.size());
    }
  };

  /// Cell sizes [mm]: @p near at a fine end, growing from cell to cell by
  /// the factor @p growth [-] up to @p far.
  struct CellSizes
  {
    double far;
    double near;
    double growth;
  };

  /// A piece of an axis.
  struct GradedInterval
  {
    double       begin;
    double       end;
    bool         fine_begin;
    bool         fine_end;
    unsigned int min_cells;
    unsigned int kind;
  };

  /// Append the cells of an interval that starts where @p axis ends (or to an
  /// empty axis). An interval without length adds nothing. With both ends
  /// fine the number of cells is even and the cells are symmetric.
  void append_interval(GridAxis             &axis,
                       const GradedInterval &interval,
                       const CellSizes      &sizes);

  /// An axis that starts at 0, continued to negative values.
  GridAxis mirrored(const GridAxis &axis);

  template <int dim>
  using CellIndex = std::array<unsigned int, dim>;

  /// Which cells of the product of axes exist, what their boundary faces are
  /// called, and where the vertices go. Faces count as in deal.II: 2 d + side.
  template <int dim>
  struct StructuredGrid
  {
    std::array<GridAxis, dim>                                         axes;
    std::function<bool(const CellIndex<dim> &)>                       keep;
    std::function<Boundary::Id(const CellIndex<dim> &, unsigned int)> face_id;
    std::function<dealii::Point<dim>(const dealii::Point<dim> &)>     map;

    /// Indices of the cells that exist, x running fastest.
    std::vector<CellIndex<dim>> cells() const;

    /// Is there no cell behind this face?
    bool at_boundary(const CellIndex<dim> &cell, unsigned int face) const;

    /// Mapped position of a grid point [mm].
    dealii::Point<dim> vertex(const CellIndex<dim> &lattice_point) const;

    /// Running number of a grid point, unique in the grid.
    std::size_t vertex_number(const CellIndex<dim> &lattice_point) const;
  };

  /// Cells and names of their boundary faces, ready for a triangulation.
  template <int dim>
  struct GridCells
  {
    std::vector<dealii::Point<dim>>                vertices;
    std::vector<dealii::CellData<dim>>             cells;
    std::vector<std::array<Boundary::Id, 2 * dim>> face_ids;
  };

  /// Add the cells of @p grid, all with @p material_id; bodies added one
  /// after the other are not connected. @p id_offset is added to boundary ids.
  template <int dim>
  void append_grid(GridCells<dim>            &cells,
                   const StructuredGrid<dim> &grid,
                   unsigned int               material_id = 0,
                   Boundary::Id               id_offset   = 0);

  /// Fill an empty triangulation (serial or parallel::shared).
  template <int dim>
  void create_triangulation(const GridCells<dim>            &cells,
                            dealii::Triangulation<dim, dim> &triangulation);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Cells of the tread block: their names at the boundary, mesh and mould.
#include <deal.II/grid/tria.h>

#include <cmath>
#include <map>

#include "geometry/mesh_check.h"
#include "geometry/tread_block.h"
#include "geometry/tread_block_shape.h"

namespace demold
{
  using namespace dealii;

  namespace
  {
    // Kinds of a cell in all directions; the slice of a 2-D block is inside
    // the width.
    template <int dim>
    struct CellKind
    {
      CellKind(const std::array<GridAxis, dim> &axes,
               const CellIndex<dim>            &cell)
        : x(axes[0].kinds[cell[0]])
        , y(dim == 3 ? axes[1].kinds[cell[1]] : BlockPart::lamella)
        , z(axes[dim - 1].kinds[cell[dim - 1]])
      {}

      bool beside_block() const
      {
        return x == BlockPart::overhang || y == BlockPart::overhang;
      }

      bool is_rubber() const
      {
        const bool in_slot =
          x == BlockPart::slot && z == BlockPart::beside_blade;
        return z >= BlockPart::base || (!beside_block() && !in_slot);
      }

      // 0: block or base, 1 and up: a layer behind them
      unsigned int layer() const
      {
        return z < BlockPart::first_layer ? 0 : z - BlockPart::first_layer + 1;
      }

      unsigned int x, y, z;
    };

    template <int dim>
    Boundary::Id block_face_id(const TreadBlock                &block,
                               const std::array<GridAxis, dim> &axes,
                               const CellIndex<dim>            &cell,
                               const unsigned int               face)
    {
      const unsigned int  d = face / 2, side = face % 2;
      const bool          first = (side == 0 && cell[d] == 0);
      const CellKind<dim> own(axes, cell);

      if (d == dim - 1)
        {
          if (side == 1)
            return Boundary::backing;
          if (first)
            return own.beside_block() ? Boundary::groove : Boundary::bottom;
          return own.beside_block() ? Boundary::groove : Boundary::sipe;
        }
      if (first && d == 0 && block.reduced_x())
        return Boundary::symmetry_x;
      if (first && d == 1 && block.reduced_y(dim))
        return Boundary::symmetry_y;
      if (own.z >= BlockPart::first_layer)
        return d == 0 ? Boundary::layer_x : Boundary::layer_y;
      if (own.z == BlockPart::base)
        return Boundary::free_side;

      const bool last = (side == 1 && cell[d] + 1 == axes[d].n_cells());
      if (d == 0 && !first && !last &&
          axes[0].kinds[cell[0] + side * 2 - 1] == BlockPart::slot)
        return Boundary::sipe;
      return Boundary::wall;
    }

    // One more cell beyond a symmetry plane, as long as the first one.
    void extend(GridAxis &axis)
    {
      axis.lines.insert(axis.lines.begin(), -axis.lines[1]);
      axis.kinds.insert(axis.kinds.begin(), axis.kinds.front());
    }

    unsigned int mould_patch(const TreadBlock  &block,
                             const Boundary::Id id,
                             const unsigned int direction,
                             const unsigned int side,
                             const bool         horizontal,
                             const double       upright_x)
    {
      if (id == Boundary::groove)
        return MouldPatch::land;
      if (id == Boundary::sipe)
        {
          const double first = -0.5 * (block.sipes - 1.0) * block.sipe_spacing;
          const unsigned int blade =
            block.sipes == 1 ?
              0 :
              std::lround((upright_x - first) / block.sipe_spacing);
          // Rubber ends with its high side at the low flank of the blade.
          const unsigned int part = horizontal  ? MouldPatch::blade_end :
                                    (side == 1) ? MouldPatch::low_flank :
                                                  MouldPatch::high_flank;
          return MouldPatch::first_blade + 3 * blade + part;
        }
      if (id == Boundary::bottom || block.corner_radius > 0)
        return MouldPatch::bottom;
      return MouldPatch::wall + 2 * direction + side;
    }

    // Lattice points around a face, so that the normal points into the cell.
    template <int dim>
    std::vector<CellIndex<dim>> facet_corners(const CellIndex<dim> &cell,
                                              const unsigned int    face)
    {
      const unsigned int d = face / 2, side = face % 2;
      CellIndex<dim>     origin = cell;
      origin[d] += side;
      const auto at = [&](const unsigned int i, const unsigned int j) {
        CellIndex<dim> corner = origin;
        corner[(d + 1) % dim] += i;
        if (dim == 3)
          corner[(d + 2) % dim] += j;
        return corner;
      };
      if (dim == 2)
        {
          // n = (t_y, -t_x): up along x faces, back along y faces.
          const bool forward = ((d == 0) == (side == 0));
          return {at(forward ? 0 : 1, 0), at(forward ? 1 : 0, 0)};
        }
      if (side == 0)
        return {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
      return {at(0, 0), at(0, 1), at(1, 1), at(1, 0)};
    }

    bool touches_mould(const Boundary::Id id)
    {
      return id == Boundary::bottom || id == Boundary::wall ||
             id == Boundary::sipe || id == Boundary::groove;
    }

    template <int dim>
    RigidSurface mould_from(const TreadBlock                &block,
                            const std::array<GridAxis, dim> &axes)
    {
      const StructuredGrid<dim> grid = block_grid<dim>(block, axes);

      RigidSurface                        mould;
      std::map<std::size_t, unsigned int> index_of;
      for (const CellIndex<dim> &cell : grid.cells())
        for (unsigned int f = 0; f < 2 * dim; ++f)
          {
            if (!grid.at_boundary(cell, f))
              continue;
            const Boundary::Id id = grid.face_id(cell, f);
            if (!touches_mould(id))
              continue;

            RigidSurface::Facet facet{{}, 0};
            for (const CellIndex<dim> &corner : facet_corners<dim>(cell, f))
              {
                const auto [entry, is_new] =
                  index_of.emplace(grid.vertex_number(corner),
                                   mould.vertices.size());
                if (is_new)
                  {
                    const Point<dim> p = grid.vertex(corner);
                    mould.vertices.emplace_back(p[0],
                                                p[1],
                                                dim == 3 ? p[dim - 1] : 0);
                  }
                facet.v[facet.n++] = entry->second;
              }
            mould.facets.push_back(facet);

            const auto  &x         = axes[0].lines;
            const double upright_x = f / 2 == 0 ?
                                       x[cell[0] + f % 2] :
                                       0.5 * (x[cell[0]] + x[cell[0] + 1]);
            mould.patch.push_back(mould_patch(block,
                                              id,
                                              f / 2,
                                              f % 2,
                                              f / 2 == dim - 1,
                                              upright_x));
          }
      return mould;
    }

    template <int dim>
    RigidSurface extended_mould(const TreadBlock &block)
    {
      auto axes = mould_axes<dim>(block);
      if (block.reduced_x())
        extend(axes[0]);
      if (block.reduced_y(dim))
        extend(axes[1]);
      return mould_from<dim>(block, axes);
    }
  } // namespace

  template <int dim>
  StructuredGrid<dim> block_grid(const TreadBlock                &block,
                                 const std::array<GridAxis, dim> &axes)
  {
    StructuredGrid<dim> grid;
    grid.axes = axes;
    grid.keep = [axes](const CellIndex<dim> &cell) {
      return CellKind<dim>(axes, cell).is_rubber();
    };
    grid.face_id = [block, axes](const CellIndex<dim> &cell,
                                 const unsigned int    face) {
      return block_face_id<dim>(block, axes, cell, face);
    };
    grid.map = [shape = BlockShape(block)](const Point<dim> &p) {
      const Point<3> image =
        shape(Point<3>(p[0], dim == 3 ? p[1] : 0, p[dim - 1]));
      Point<dim> mapped;
      mapped[0] = image[0];
      if (dim == 3)
        mapped[1] = image[1];
      mapped[dim - 1] = image[2];
      return mapped;
    };
    return grid;
  }

  template <int dim>
  void make_tread_block(const TreadBlock        &block,
                        Triangulation<dim, dim> &triangulation)
  {
    block.check(dim);
    GridCells<dim>            cells;
    const StructuredGrid<dim> grid =
      block_grid<dim>(block, rubber_axes<dim>(block));
    append_grid(cells, grid);
    auto data = cells.cells.begin();
    for (const CellIndex<dim> &cell : grid.cells())
      (data++)->material_id = CellKind<dim>(grid.axes, cell).layer();
    create_triangulation(cells, triangulation);
    check_cells(triangulation, "Block/corner radius");
  }

  RigidSurface make_mould(const TreadBlock &block, const int dim)
  {
    block.check(dim);
    return dim == 3 ? extended_mould<3>(block) : extended_mould<2>(block);
  }

  double contact_area(const TreadBlock &block, const int dim)
  {
    const RigidSurface touching = dim == 3 ?
                                    mould_from<3>(block, mould_axes<3>(block)) :
                                    mould_from<2>(block, mould_axes<2>(block));
    return block.symmetry_factor(dim) * surface_area(touching);
  }

  template StructuredGrid<2> block_grid<2>(const TreadBlock &,
                                           const std::array<GridAxis, 2> &);
  template StructuredGrid<3> block_grid<3>(const TreadBlock &,
                                           const std::array<GridAxis, 3> &);
  template void make_tread_block(const TreadBlock &, Triangulation<2, 2> &);
  template void make_tread_block(const TreadBlock &, Triangulation<3, 3> &);
} // namespace demold

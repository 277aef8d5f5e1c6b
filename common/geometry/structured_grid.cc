// SPDX-License-Identifier: LGPL-2.1-or-later
// Graded lines, cells between them, and the triangulation made of these.
#include "geometry/structured_grid.h"

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace demold
{
  using namespace dealii;

  namespace
  {
    // Local size near + g s with g = ln(growth), at most far: along it
    // neighbouring cells differ by the factor growth. count(s) is the number
    // of such cells on [0, s], position() its inverse.
    struct SizeFunction
    {
      explicit SizeFunction(const CellSizes &sizes)
        : near(std::min(sizes.near, sizes.far))
        , far(sizes.far)
        , g(std::log(sizes.growth))
        , growing_length((far - near) / g)
        , growing_count(std::log(far / near) / g)
      {}

      double count(const double s) const
      {
        return s <= growing_length ? std::log1p(g * s / near) / g :
                                     growing_count + (s - growing_length) / far;
      }

      double position(const double n) const
      {
        return n <= growing_count ? near * std::expm1(g * n) / g :
                                    growing_length + (n - growing_count) * far;
      }

      double near, far, g, growing_length, growing_count;
    };

    // Lines from 0 to length, fine at 0.
    std::vector<double> one_sided_lines(const double        length,
                                        const unsigned int  min_cells,
                                        const SizeFunction &size)
    {
      const double       count = size.count(length);
      const unsigned int n     = std::max<unsigned int>(
        {1, min_cells, unsigned(std::ceil(count - 1e-6))});
      std::vector<double> lines(n + 1);
      for (unsigned int i = 0; i < n; ++i)
        lines[i] = size.position(count * i / n);
      lines[n] = length;
      return lines;
    }

    // x -> length - x, ascending again.
    std::vector<double> turned_round(const std::vector<double> &lines)
    {
      std::vector<double> turned(lines.rbegin(), lines.rend());
      for (double &x : turned)
        x = lines.back() - x;
      return turned;
    }

    std::vector<double> graded_lines(const GradedInterval &interval,
                                     const CellSizes      &sizes)
    {
      const double       length  = interval.end - interval.begin;
      const bool         uniform = !interval.fine_begin && !interval.fine_end;
      const bool         both    = interval.fine_begin && interval.fine_end;
      const SizeFunction size(
        uniform ? CellSizes{sizes.far, sizes.far, sizes.growth} : sizes);

      if (both)
        {
          std::vector<double> lines =
            one_sided_lines(length / 2, (interval.min_cells + 1) / 2, size);
          for (int i = int(lines.size()) - 2; i >= 0; --i)
            lines.push_back(length - lines[i]);
          return lines;
        }
      const auto lines = one_sided_lines(length, interval.min_cells, size);
      return interval.fine_end ? turned_round(lines) : lines;
    }
  } // namespace

  void append_interval(GridAxis             &axis,
                       const GradedInterval &interval,
                       const CellSizes      &sizes)
  {
    if (interval.end - interval.begin <= 0)
      return;
    if (axis.lines.empty())
      axis.lines.push_back(interval.begin);
    const std::vector<double> lines = graded_lines(interval, sizes);
    for (std::size_t i = 1; i < lines.size(); ++i)
      {
        // The end itself, not a rounded sum: kinks of the shape sit there.
        axis.lines.push_back(i + 1 < lines.size() ? interval.begin + lines[i] :
                                                    interval.end);
        axis.kinds.push_back(interval.kind);
      }
  }

  GridAxis mirrored(const GridAxis &axis)
  {
    GridAxis whole;
    for (std::size_t i = axis.lines.size() - 1; i > 0; --i)
      whole.lines.push_back(-axis.lines[i]);
    whole.lines.insert(whole.lines.end(), axis.lines.begin(), axis.lines.end());
    whole.kinds.assign(axis.kinds.rbegin(), axis.kinds.rend());
    whole.kinds.insert(whole.kinds.end(), axis.kinds.begin(), axis.kinds.end());
    return whole;
  }

  template <int dim>
  std::vector<CellIndex<dim>> StructuredGrid<dim>::cells() const
  {
    std::size_t n = 1;
    for (const GridAxis &axis : axes)
      n *= axis.n_cells();

    std::vector<CellIndex<dim>> kept;
    for (std::size_t number = 0; number < n; ++number)
      {
        CellIndex<dim> cell;
        std::size_t    rest = number;
        for (unsigned int d = 0; d < dim; ++d)
          {
            cell[d] = rest % axes[d].n_cells();
            rest /= axes[d].n_cells();
          }
        if (keep(cell))
          kept.push_back(cell);
      }
    return kept;
  }

  template <int dim>
  bool StructuredGrid<dim>::at_boundary(const CellIndex<dim> &cell,
                                        const unsigned int    face) const
  {
    const unsigned int d = face / 2, side = face % 2;
    if (cell[d] == (side == 0 ? 0 : axes[d].n_cells() - 1))
      return true;
    CellIndex<dim> neighbour = cell;
    neighbour[d] += (side == 0 ? -1 : 1);
    return !keep(neighbour);
  }

  template <int dim>
  Point<dim>
  StructuredGrid<dim>::vertex(const CellIndex<dim> &lattice_point) const
  {
    Point<dim> p;
    for (unsigned int d = 0; d < dim; ++d)
      p[d] = axes[d].lines[lattice_point[d]];
    return map(p);
  }

  template <int dim>
  std::size_t
  StructuredGrid<dim>::vertex_number(const CellIndex<dim> &lattice_point) const
  {
    std::size_t number = 0;
    for (int d = dim - 1; d >= 0; --d)
      number = number * axes[d].lines.size() + lattice_point[d];
    return number;
  }

  template <int dim>
  void append_grid(GridCells<dim>            &cells,
                   const StructuredGrid<dim> &grid,
                   const unsigned int         material_id,
                   const Boundary::Id         id_offset)
  {
    std::map<std::size_t, unsigned int> index_of;
    for (const CellIndex<dim> &cell : grid.cells())
      {
        CellData<dim> data;
        for (unsigned int v = 0; v < (1u << dim); ++v)
          {
            CellIndex<dim> corner = cell;
            for (unsigned int d = 0; d < dim; ++d)
              corner[d] += (v >> d) & 1u;
            const auto [entry, is_new] =
              index_of.emplace(grid.vertex_number(corner),
                               cells.vertices.size());
            if (is_new)
              cells.vertices.push_back(grid.vertex(corner));
            data.vertices[v] = entry->second;
          }
        data.material_id = material_id;
        cells.cells.push_back(data);

        std::array<Boundary::Id, 2 * dim> ids;
        for (unsigned int f = 0; f < 2 * dim; ++f)
          ids[f] = grid.at_boundary(cell, f) ?
                     grid.face_id(cell, f) + id_offset :
                     Boundary::unnamed;
        cells.face_ids.push_back(ids);
      }
  }

  template <int dim>
  void create_triangulation(const GridCells<dim>    &cells,
                            Triangulation<dim, dim> &triangulation)
  {
    triangulation.create_triangulation(cells.vertices,
                                       cells.cells,
                                       SubCellData());
    // Coarse cells keep the order and the face numbers they were given in.
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          cell->face(f)->set_boundary_id(cells.face_ids[cell->index()][f]);
  }

  template struct StructuredGrid<2>;
  template struct StructuredGrid<3>;
  template void append_grid(GridCells<2> &,
                            const StructuredGrid<2> &,
                            unsigned int,
                            Boundary::Id);
  template void append_grid(GridCells<3> &,
                            const StructuredGrid<3> &,
                            unsigned int,
                            Boundary::Id);
  template void create_triangulation(const GridCells<2> &,
                                     Triangulation<2, 2> &);
  template void create_triangulation(const GridCells<3> &,
                                     Triangulation<3, 3> &);
} // namespace demold

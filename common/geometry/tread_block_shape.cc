// SPDX-License-Identifier: LGPL-2.1-or-later
// The upright block's lines and the map from the upright to the real block.
#include "geometry/tread_block_shape.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    double tangent(const double degree)
    {
      return std::tan(degree * numbers::PI / 180);
    }

    // How cells are counted out along the axes.
    struct AxisSizes
    {
      CellSizes    cells;
      CellSizes    corner;
      unsigned int corner_cells; // at least, along a corner radius
      unsigned int lamella_cells;
    };

    AxisSizes rubber_sizes(const TreadBlock &block)
    {
      const double near = block.wall_element_size;
      return {{block.element_size, near, block.growth},
              {near, near, block.growth},
              2,
              block.min_elements};
    }

    AxisSizes mould_sizes(const TreadBlock &block)
    {
      const double    h = block.facet_size;
      const CellSizes even{h, h, 2};
      return {even, even, 8, 1};
    }

    // From the last line to the outer wall, in two pieces for a rounded edge,
    // and on to the end of an overhanging base.
    void append_wall(GridAxis          &axis,
                     const TreadBlock  &block,
                     const AxisSizes   &sizes,
                     const double       begin,
                     const double       wall,
                     const bool         fine_begin,
                     const unsigned int min_cells)
    {
      const double r = block.corner_radius;
      append_interval(
        axis,
        {begin, wall - r, fine_begin, true, min_cells, BlockPart::lamella},
        sizes.cells);
      append_interval(
        axis,
        {wall - r, wall, false, false, sizes.corner_cells, BlockPart::lamella},
        sizes.corner);
      append_interval(
        axis,
        {wall, wall + block.base_overhang, true, false, 1, BlockPart::overhang},
        sizes.cells);
    }

    GridAxis x_axis(const TreadBlock          &block,
                    const AxisSizes           &sizes,
                    const std::vector<double> &slots)
    {
      const double       t    = block.sipe_thickness;
      const unsigned int n    = sizes.lamella_cells;
      const unsigned int half = (n + 1) / 2;
      GridAxis           axis;
      double             begin = 0;
      for (const double middle : slots)
        {
          // The first piece ends at the middle of the block: half of it is
          // in the mirrored part.
          const bool centred = (middle == 0);
          append_interval(axis,
                          {begin,
                           middle - t / 2,
                           begin > 0,
                           true,
                           begin > 0 ? n : half,
                           BlockPart::lamella},
                          sizes.cells);
          append_interval(axis,
                          {centred ? 0 : middle - t / 2,
                           middle + t / 2,
                           false,
                           false,
                           centred ? half : n,
                           BlockPart::slot},
                          sizes.corner);
          begin = middle + t / 2;
        }
      append_wall(axis,
                  block,
                  sizes,
                  begin,
                  block.length / 2,
                  begin > 0,
                  begin > 0 ? n : half);
      return axis;
    }

    GridAxis y_axis(const TreadBlock &block, const AxisSizes &sizes)
    {
      GridAxis axis;
      append_wall(axis,
                  block,
                  sizes,
                  0,
                  block.width / 2,
                  false,
                  (sizes.lamella_cells + 1) / 2);
      return axis;
    }

    GridAxis z_axis(const TreadBlock &block, const AxisSizes &sizes)
    {
      const double r   = block.corner_radius;
      const double H   = block.height;
      const double end = block.sipes > 0 ? block.sipe_depth : H;

      GridAxis axis;
      append_interval(
        axis,
        {0, r, false, false, sizes.corner_cells, BlockPart::beside_blade},
        sizes.corner);
      append_interval(
        axis,
        {r, end, true, true, sizes.lamella_cells, BlockPart::beside_blade},
        sizes.cells);
      append_interval(
        axis,
        {end, H, true, true, sizes.lamella_cells, BlockPart::above_blade},
        sizes.cells);
      append_interval(
        axis,
        {H, H + block.base_thickness, true, false, 1, BlockPart::base},
        sizes.cells);
      double       z    = H + block.base_thickness;
      unsigned int kind = BlockPart::first_layer;
      for (const double thickness : block.layers)
        {
          append_interval(axis,
                          {z, z + thickness, z == H, false, 1, kind++},
                          sizes.cells);
          z += thickness;
        }
      return axis;
    }

    template <int dim>
    std::array<GridAxis, dim> make_axes(const TreadBlock &block,
                                        const AxisSizes  &sizes)
    {
      std::array<GridAxis, dim> axes;
      axes[0] = x_axis(block, sizes, BlockShape(block).slots());
      if (dim == 3)
        axes[1] = y_axis(block, sizes);
      axes[dim - 1] = z_axis(block, sizes);
      if (!block.reduced_x())
        axes[0] = mirrored(axes[0]);
      if (dim == 3 && !block.reduced_y(dim))
        axes[1] = mirrored(axes[1]);
      return axes;
    }
  } // namespace

  BlockShape::BlockShape(const TreadBlock &block)
    : block(block)
  {
    for (unsigned int i = block.sipes / 2; i < block.sipes; ++i)
      slot_middles.push_back((i - 0.5 * (block.sipes - 1.0)) *
                             block.sipe_spacing);
  }

  double BlockShape::half_length(const double z) const
  {
    return block.length / 2 +
           std::min(z, block.height) * tangent(block.draft_angle);
  }

  double BlockShape::half_width(const double z) const
  {
    return block.width / 2 +
           std::min(z, block.height) * tangent(block.draft_angle);
  }

  double BlockShape::half_slot(const double z) const
  {
    return block.sipe_thickness / 2 -
           std::min(z, block.sipe_depth) * tangent(block.sipe_draft_angle);
  }

  const std::vector<double> &BlockShape::slots() const
  {
    return slot_middles;
  }

  Point<3> BlockShape::round_edges(const Point<3> &p) const
  {
    const double r = block.corner_radius;
    if (r == 0)
      return p;
    // From the centre of the rounding outwards, in radii.
    const double inner_x  = block.length / 2 - r;
    const double inner_y  = block.width / 2 - r;
    const auto   outwards = [r](const double s) {
      return std::min(1., std::max(0., s / r));
    };
    const double u = outwards(std::abs(p[0]) - inner_x);
    const double v = outwards(std::abs(p[1]) - inner_y);
    const double w = outwards(r - p[2]);

    // Cube to ball: a face of the cube goes to a part of the unit sphere.
    const auto shortened = [](const double a, const double b) {
      return std::sqrt(1 - a * a / 2 - b * b / 2 + a * a * b * b / 3);
    };
    Point<3> rounded = p;
    rounded[0] -= std::copysign(r * u * (1 - shortened(v, w)), p[0]);
    rounded[1] -= std::copysign(r * v * (1 - shortened(u, w)), p[1]);
    rounded[2] += r * w * (1 - shortened(u, v));
    return rounded;
  }

  double BlockShape::drafted_x(const double x, const double z) const
  {
    // Piecewise linear between slot flanks and outer wall.
    const double s = std::abs(x), t = block.sipe_thickness;
    double       from = 0, from_drafted = 0;
    const auto   between = [&](const double to, const double to_drafted) {
      return std::copysign(from_drafted + (s - from) / (to - from) *
                                            (to_drafted - from_drafted),
                           x);
    };
    for (const double middle : slot_middles)
      for (const double side : {-1., 1.})
        {
          const double to         = middle + side * t / 2;
          const double to_drafted = middle + side * half_slot(z);
          if (to <= 0)
            continue;
          if (s <= to)
            return between(to, to_drafted);
          from         = to;
          from_drafted = to_drafted;
        }
    if (s <= block.length / 2)
      return between(block.length / 2, half_length(z));
    return std::copysign(s - block.length / 2 + half_length(z), x);
  }

  Point<3> BlockShape::operator()(const Point<3> &upright) const
  {
    const Point<3> p = round_edges(upright);
    const double   s = std::abs(p[1]), half = block.width / 2;
    const double   y =
      s <= half ? s / half * half_width(p[2]) : s - half + half_width(p[2]);
    return {drafted_x(p[0], p[2]), std::copysign(y, p[1]), p[2]};
  }

  template <int dim>
  std::array<GridAxis, dim> rubber_axes(const TreadBlock &block)
  {
    return make_axes<dim>(block, rubber_sizes(block));
  }

  template <int dim>
  std::array<GridAxis, dim> mould_axes(const TreadBlock &block)
  {
    return make_axes<dim>(block, mould_sizes(block));
  }

  template std::array<GridAxis, 2> rubber_axes<2>(const TreadBlock &);
  template std::array<GridAxis, 3> rubber_axes<3>(const TreadBlock &);
  template std::array<GridAxis, 2> mould_axes<2>(const TreadBlock &);
  template std::array<GridAxis, 3> mould_axes<3>(const TreadBlock &);
} // namespace demold

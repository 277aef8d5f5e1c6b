// SPDX-License-Identifier: LGPL-2.1-or-later
// Boxes, half cylinders and rigid polylines from structured grids.
#include "geometry/test_bodies.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/boundary_names.h"
#include "geometry/mesh_check.h"
#include "geometry/structured_grid.h"

namespace demold
{
  using namespace dealii;

  namespace
  {
    GridAxis geometric_axis(const double       begin,
                            const double       length,
                            const unsigned int n,
                            const double       grading)
    {
      AssertThrow(n > 0 && length > 0 && grading > 0,
                  ExcMessage("A box needs positive sizes, cells, gradings."));
      const double q   = n > 1 ? std::pow(grading, 1. / (n - 1)) : 1;
      double       sum = 0;
      for (unsigned int i = 0; i < n; ++i)
        sum += std::pow(q, i);

      GridAxis axis;
      axis.kinds.assign(n, 0);
      double part = 0;
      for (unsigned int i = 0; i < n; ++i)
        {
          axis.lines.push_back(begin + length * part / sum);
          part += std::pow(q, i);
        }
      axis.lines.push_back(begin + length);
      return axis;
    }

    /// Shifts the points inside a grid at random, in the order it is asked.
    template <int dim>
    struct InnerShift
    {
      std::array<GridAxis, dim> axes;
      double                    largest; ///< over the element size
      std::mt19937              random = std::mt19937(1);

      Point<dim> operator()(const Point<dim> &p)
      {
        if (largest == 0.)
          return p;
        std::array<double, dim> element;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const auto &lines = axes[d].lines;
            const auto  i = std::lower_bound(lines.begin(), lines.end(), p[d]);
            if (i == lines.begin() || i + 1 == lines.end())
              return p;
            element[d] = std::min(*i - *(i - 1), *(i + 1) - *i);
          }
        Point<dim> shifted = p;
        for (unsigned int d = 0; d < dim; ++d)
          shifted[d] +=
            largest * element[d] * (2. * random() / random.max() - 1.);
        return shifted;
      }
    };

    template <int dim>
    StructuredGrid<dim> box_grid(const Box<dim> &box)
    {
      StructuredGrid<dim> grid;
      for (unsigned int d = 0; d < dim; ++d)
        grid.axes[d] = geometric_axis(box.lower_corner[d],
                                      box.size[d],
                                      box.cells[d],
                                      box.grading[d]);
      grid.keep = [](const CellIndex<dim> &) { return true; };
      grid.map  = [shift = InnerShift<dim>{grid.axes, box.irregularity},
                  map   = box.map](const Point<dim> &p) mutable {
        return map ? map(shift(p)) : shift(p);
      };
      grid.face_id = [](const CellIndex<dim> &, const unsigned int face) {
        const unsigned int d = face / 2, side = face % 2;
        if (d == dim - 1)
          return side == 0 ? Boundary::bottom : Boundary::top;
        if (d == 1)
          return side == 0 ? Boundary::front : Boundary::back;
        return side == 0 ? Boundary::left : Boundary::right;
      };
      return grid;
    }

    // Fine over fine_length, then growing; lengths as parts of `scale`.
    GridAxis axis_from_fine_end(const FineZone &body,
                                const double    begin,
                                const double    length,
                                const double    fine_length,
                                const double    scale)
    {
      const CellSizes fine{body.fine_size / scale,
                           body.fine_size / scale,
                           body.growth};
      const CellSizes growing{body.far_size / scale,
                              body.fine_size / scale,
                              body.growth};
      const double    fine_end =
        begin + std::min(fine_length / scale, 0.5 * length);
      GridAxis axis;
      append_interval(axis, {begin, fine_end, false, false, 1, 0}, fine);
      append_interval(axis,
                      {fine_end, begin + length, true, false, 1, 0},
                      growing);
      return axis;
    }

    // Half square [-1,1] x [-1,0] to the lower half of the unit disc.
    Point<2> on_half_disc(const Point<2> &p)
    {
      return {p[0] * std::sqrt(1 - p[1] * p[1] / 2),
              p[1] * std::sqrt(1 - p[0] * p[0] / 2)};
    }

    // [-1,1] x [0,1] to a bar with a curved bottom, radius 1.
    Point<2> on_curved_bar(const Point<2> &p, const double half_angle)
    {
      const double angle = p[0] * half_angle;
      return {std::sin(angle), (p[1] - 1) * std::cos(angle)};
    }

    double fine_depth(const FineZone &body)
    {
      return body.fine_depth > 0 ? body.fine_depth : body.fine_width;
    }

    void check_sizes(const FineZone &body)
    {
      AssertThrow(body.fine_size > 0 && body.fine_size <= body.far_size &&
                    body.growth > 1 && body.fine_width > 0,
                  ExcMessage(
                    "Fine cells must be positive and at most far_size, "
                    "the growth above 1."));
    }

    StructuredGrid<2> half_cylinder_grid(const HalfCylinder &body)
    {
      const bool is_disc = (body.half_angle == 90);
      AssertThrow(is_disc || (body.half_angle > 0 && body.half_angle <= 75),
                  ExcMessage(
                    "The half angle must be 90 or in (0, 75] degree."));
      check_sizes(body);
      const double R     = body.radius;
      const double angle = body.half_angle * numbers::PI / 180;

      StructuredGrid<2> grid;
      // At the lowest point a step dx of the half square is R dx / sqrt(2)
      // long.
      grid.axes[0] =
        axis_from_fine_end(body,
                           0,
                           1,
                           body.fine_width,
                           is_disc ? R / std::sqrt(2.) : R * angle);
      grid.axes[1] =
        axis_from_fine_end(body, is_disc ? -1 : 0, 1, fine_depth(body), R);
      if (!body.right_half)
        grid.axes[0] = mirrored(grid.axes[0]);

      grid.keep = [](const CellIndex<2> &) { return true; };
      grid.map  = [=](const Point<2> &p) {
        const Point<2> unit =
          is_disc ? on_half_disc(p) : on_curved_bar(p, angle);
        return Point<2>(body.lowest[0] + R * unit[0],
                        body.lowest[1] + R * (1 + unit[1]));
      };
      grid.face_id = [=](const CellIndex<2> &, const unsigned int face) {
        if (face == 3)
          return Boundary::top;
        if (face == 0 && body.right_half)
          return Boundary::symmetry_x;
        if (face == 2 || is_disc)
          return Boundary::bottom;
        return face == 0 ? Boundary::left : Boundary::right;
      };
      return grid;
    }

    StructuredGrid<2> graded_box_grid(const GradedBox &box)
    {
      check_sizes(box);
      const double    x = box.lower_corner[0], y = box.lower_corner[1];
      const double    right = x + box.size[0];
      const double    begin = std::max(x, box.fine_centre - box.fine_width);
      const double    end   = std::min(right, box.fine_centre + box.fine_width);
      const CellSizes fine{box.fine_size, box.fine_size, box.growth};
      const CellSizes growing{box.far_size, box.fine_size, box.growth};
      AssertThrow(begin < end,
                  ExcMessage("The fine zone must lie in the box."));

      StructuredGrid<2> grid;
      GridAxis         &along = grid.axes[0];
      append_interval(along, {x, begin, false, true, 1, 0}, growing);
      append_interval(along, {begin, end, false, false, 1, 0}, fine);
      append_interval(along, {end, right, true, false, 1, 0}, growing);
      grid.axes[1] =
        axis_from_fine_end(box, y, box.size[1], fine_depth(box), 1);
      grid.keep    = [](const CellIndex<2> &) { return true; };
      grid.map     = [](const Point<2> &p) { return p; };
      grid.face_id = [](const CellIndex<2> &, const unsigned int face) {
        return std::array<Boundary::Id, 4>{{Boundary::left,
                                            Boundary::right,
                                            Boundary::bottom,
                                            Boundary::top}}[face];
      };
      return grid;
    }
  } // namespace

  template <int dim>
  void make_box(const Box<dim> &box, Triangulation<dim, dim> &triangulation)
  {
    GridCells<dim> cells;
    append_grid(cells, box_grid(box), box.material_id);
    create_triangulation(cells, triangulation);
    check_cells(triangulation, "box");
  }

  template <int dim>
  void make_two_boxes(const Box<dim>          &upper,
                      const Box<dim>          &lower,
                      Triangulation<dim, dim> &triangulation)
  {
    GridCells<dim> cells;
    append_grid(cells, box_grid(upper), 0);
    append_grid(cells, box_grid(lower), 1, Boundary::base_offset);
    create_triangulation(cells, triangulation);
    check_cells(triangulation, "two boxes");
  }

  void make_half_cylinder(const HalfCylinder  &body,
                          Triangulation<2, 2> &triangulation)
  {
    GridCells<2> cells;
    append_grid(cells, half_cylinder_grid(body));
    create_triangulation(cells, triangulation);
    check_cells(triangulation, "half cylinder");
  }

  void make_half_cylinder_on_box(const HalfCylinder  &upper,
                                 const Box<2>        &lower,
                                 Triangulation<2, 2> &triangulation)
  {
    GridCells<2> cells;
    append_grid(cells, half_cylinder_grid(upper));
    append_grid(cells, box_grid(lower), 1, Boundary::base_offset);
    create_triangulation(cells, triangulation);
    check_cells(triangulation, "half cylinder on a box");
  }

  void make_graded_box(const GradedBox &box, Triangulation<2, 2> &triangulation)
  {
    GridCells<2> cells;
    append_grid(cells, graded_box_grid(box));
    create_triangulation(cells, triangulation);
    check_cells(triangulation, "graded box");
  }

  template void make_box(const Box<2> &, Triangulation<2, 2> &);
  template void make_box(const Box<3> &, Triangulation<3, 3> &);
  template void make_two_boxes(const Box<2> &,
                               const Box<2> &,
                               Triangulation<2, 2> &);
  template void make_two_boxes(const Box<3> &,
                               const Box<3> &,
                               Triangulation<3, 3> &);
} // namespace demold

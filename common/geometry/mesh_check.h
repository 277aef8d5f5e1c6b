// SPDX-License-Identifier: LGPL-2.1-or-later
// Volume, boundary areas and distorted cells of a mesh of straight cells.
#ifndef demold_geometry_mesh_check_h
#define demold_geometry_mesh_check_h

#include <deal.II/base/point.h>

#include <array>
#include <string>

#include "geometry/boundary_names.h"

namespace dealii
{
  template <int dim, int spacedim>
  class Triangulation;
}

namespace demold
{
  /// Corners of a cell in deal.II's (lexicographic) order [mm].
  template <int dim>
  using CellCorners = std::array<dealii::Point<dim>, (1 << dim)>;

  /// Determinant of the (multi-)linear map of the unit cell [mm^dim] at the
  /// reference point @p xi in [0,1]^dim.
  template <int dim>
  double jacobian(const CellCorners<dim>   &corners,
                  const dealii::Point<dim> &xi);

  /// Smallest determinant over corners, middles of edges and faces, and the
  /// centre [mm^dim]; positive for a usable cell.
  template <int dim>
  double smallest_jacobian(const CellCorners<dim> &corners);

  /// Volume of all active cells [mm^dim], exact for (multi-)linear cells.
  template <int dim>
  double mesh_volume(const dealii::Triangulation<dim, dim> &triangulation);

  /// Area of all boundary faces with this id [mm^(dim-1)].
  template <int dim>
  double boundary_area(const dealii::Triangulation<dim, dim> &triangulation,
                       Boundary::Id                           id);

  /// Throw ExcParameter(@p path, ...) naming the first cell that is folded or
  /// flat, where it lies and its determinant.
  template <int dim>
  void check_cells(const dealii::Triangulation<dim, dim> &triangulation,
                   const std::string                     &path);
} // namespace demold

#endif

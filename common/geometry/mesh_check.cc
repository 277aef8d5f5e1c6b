// SPDX-License-Identifier: LGPL-2.1-or-later
// Integrals and determinants straight from the corners, without FEValues.
#include "geometry/mesh_check.h"

#include "base/parameter_error.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/tensor.h>

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    template <int dim, typename Cell>
    CellCorners<dim> corners_of(const Cell &cell)
    {
      CellCorners<dim> corners;
      for (unsigned int v = 0; v < corners.size(); ++v)
        corners[v] = cell->vertex(v);
      return corners;
    }

    double face_area(const TriaAccessor<1, 2, 2> &face)
    {
      return face.vertex(0).distance(face.vertex(1));
    }

    // Also right for faces that are not plane, where TriaAccessor::measure
    // gives up.
    double face_area(const TriaAccessor<2, 3, 3> &face)
    {
      double          area = 0;
      const QGauss<2> gauss(2);
      for (unsigned int q = 0; q < gauss.size(); ++q)
        {
          Tensor<1, 3> t[2];
          for (unsigned int v = 0; v < 4; ++v)
            {
              const Tensor<1, 2> gradient =
                GeometryInfo<2>::d_linear_shape_function_gradient(gauss.point(
                                                                    q),
                                                                  v);
              t[0] += gradient[0] * face.vertex(v);
              t[1] += gradient[1] * face.vertex(v);
            }
          area += cross_product_3d(t[0], t[1]).norm() * gauss.weight(q);
        }
      return area;
    }
  } // namespace

  template <int dim>
  double jacobian(const CellCorners<dim> &corners, const Point<dim> &xi)
  {
    Tensor<2, dim> J;
    for (unsigned int v = 0; v < corners.size(); ++v)
      J += outer_product(
        Tensor<1, dim>(corners[v]),
        Tensor<1, dim>(
          GeometryInfo<dim>::d_linear_shape_function_gradient(xi, v)));
    return determinant(J);
  }

  template <int dim>
  double smallest_jacobian(const CellCorners<dim> &corners)
  {
    double       smallest = std::numeric_limits<double>::max();
    unsigned int n_points = 1;
    for (unsigned int d = 0; d < dim; ++d)
      n_points *= 3;
    for (unsigned int i = 0; i < n_points; ++i)
      {
        Point<dim>   xi;
        unsigned int rest = i;
        for (unsigned int d = 0; d < dim; ++d, rest /= 3)
          xi[d] = 0.5 * (rest % 3);
        smallest = std::min(smallest, jacobian<dim>(corners, xi));
      }
    return smallest;
  }

  template <int dim>
  double mesh_volume(const Triangulation<dim, dim> &triangulation)
  {
    double            volume = 0;
    const QGauss<dim> gauss(2);
    for (const auto &cell : triangulation.active_cell_iterators())
      for (unsigned int q = 0; q < gauss.size(); ++q)
        volume += jacobian<dim>(corners_of<dim>(cell), gauss.point(q)) *
                  gauss.weight(q);
    return volume;
  }

  template <int dim>
  double boundary_area(const Triangulation<dim, dim> &triangulation,
                       const Boundary::Id             id)
  {
    double area = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == id)
          area += face_area(*face);
    return area;
  }

  template <int dim>
  void check_cells(const Triangulation<dim, dim> &triangulation,
                   const std::string             &path)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        const double smallest = smallest_jacobian<dim>(corners_of<dim>(cell));
        if (smallest > 0)
          continue;
        std::ostringstream text;
        text << "cell " << cell->index() << " around (" << cell->center()
             << ") mm is folded or flat: the determinant of "
             << "its map must be above 0 mm^" << dim << "; it falls to "
             << smallest << ". Use smaller elements or a simpler shape.";
        throw ExcParameter(path, text.str());
      }
  }

  template double jacobian<2>(const CellCorners<2> &, const Point<2> &);
  template double jacobian<3>(const CellCorners<3> &, const Point<3> &);
  template double smallest_jacobian<2>(const CellCorners<2> &);
  template double smallest_jacobian<3>(const CellCorners<3> &);
  template double mesh_volume(const Triangulation<2, 2> &);
  template double mesh_volume(const Triangulation<3, 3> &);
  template double boundary_area(const Triangulation<2, 2> &, Boundary::Id);
  template double boundary_area(const Triangulation<3, 3> &, Boundary::Id);
  template void   check_cells(const Triangulation<2, 2> &, const std::string &);
  template void   check_cells(const Triangulation<3, 3> &, const std::string &);
} // namespace demold

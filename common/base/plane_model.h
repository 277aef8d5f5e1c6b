// SPDX-License-Identifier: LGPL-2.1-or-later
// What a two-dimensional mesh stands for: a slice or a body of revolution.
#ifndef demold_base_plane_model_h
#define demold_base_plane_model_h

#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>

namespace demold
{
  /// Plane strain of a given thickness, or axisymmetric about the y axis with
  /// x = R. Without meaning in three dimensions.
  struct PlaneModel
  {
    bool   axisymmetric = false; ///< F_33 = r/R
    double thickness    = 1.;    ///< [mm] of a plane-strain slice
  };

  /// Length [mm] that turns an area of the mesh into a volume: thickness,
  /// 2 pi R, or 1 in three dimensions.
  template <int dim>
  double plane_weight(const PlaneModel &model, const dealii::Point<dim> &X)
  {
    if (dim == 3)
      return 1.;
    return model.axisymmetric ? 2. * dealii::numbers::PI * X[0] :
                                model.thickness;
  }

  /// A point of the mesh in space, z = 0 in two dimensions.
  template <int dim>
  dealii::Point<3> in_space(const dealii::Point<dim> &X)
  {
    return dim == 3 ? dealii::Point<3>(X[0], X[1], X[dim - 1]) :
                      dealii::Point<3>(X[0], X[1], 0.);
  }
} // namespace demold

#endif

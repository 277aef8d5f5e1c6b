// SPDX-License-Identifier: LGPL-2.1-or-later
// Springs and bars: elements of a few unknowns with a stored energy.
#ifndef demold_network_elastic_link_h
#define demold_network_elastic_link_h

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace demold
{
  /// Energy [mJ], its gradient [N] and second derivative [N/mm] by the
  /// displacements of one element.
  struct LinkResponse
  {
    double                     energy = 0.;
    dealii::Vector<double>     R;
    dealii::FullMatrix<double> K;
  };

  /// Linear spring between two displacements: W = k (u_b - u_a)^2/2.
  struct Spring
  {
    std::vector<dealii::types::global_dof_index> unknowns;  ///< a, b
    double                                       stiffness; ///< k [N/mm]

    LinkResponse response(const std::vector<double> &u) const;
  };

  /// Bar between two nodes in the plane at finite rotation: W = EA L E^2/2
  /// with Green's strain E = (l^2 - L^2)/(2 L^2) (benchmark of von Mises).
  struct Bar
  {
    std::vector<dealii::types::global_dof_index> unknowns; ///< ax, ay, bx, by
    dealii::Point<2>                             a, b;     ///< [mm] reference
    double                                       EA;       ///< [N]

    LinkResponse response(const std::vector<double> &u) const;
  };
} // namespace demold

#endif

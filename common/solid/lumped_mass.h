// SPDX-License-Identifier: LGPL-2.1-or-later
// The mass of each unknown.
#ifndef demold_solid_lumped_mass_h
#define demold_solid_lumped_mass_h

#include "base/plane_model.h"
#include "weak_form/algebra.h"

namespace dealii
{
  template <int dim, int spacedim>
  class DoFHandler;
}

namespace demold
{
  /// Row sums of the mass matrix [t] of the owned unknowns; @p density in
  /// [t/mm^3], the result has the layout of @p layout.
  template <int dim>
  Vector lumped_mass(const dealii::DoFHandler<dim, dim> &dof_handler,
                     const PlaneModel                   &plane,
                     const double                        density,
                     const Vector                       &layout);
} // namespace demold

#endif

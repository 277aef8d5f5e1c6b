// SPDX-License-Identifier: LGPL-2.1-or-later
// The displacement unknowns of a distributed finite element mesh.
#ifndef demold_weak_form_displacement_space_h
#define demold_weak_form_displacement_space_h

#include "weak_form/weak_form.h"

namespace dealii
{
  template <int dim, int spacedim>
  class DoFHandler;
}

namespace demold
{
  /// The unknowns of @p dof_handler, which must live as long as the result,
  /// and the couplings of its cells.
  template <int dim>
  DisplacementSpace
  displacement_space(const dealii::DoFHandler<dim, dim> &dof_handler);
} // namespace demold

#endif

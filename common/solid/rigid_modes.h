// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid-body modes: the near null space that multigrid needs.
#ifndef demold_solid_rigid_modes_h
#define demold_solid_rigid_modes_h

#include "weak_form/algebra.h"

#include <vector>

namespace dealii
{
  template <int dim, int spacedim>
  class DoFHandler;
}

namespace demold
{
  /// Translations, then rotations about the centre of the mesh: 3 vectors in
  /// two dimensions, 6 in three, in the layout of @p layout.
  template <int dim>
  std::vector<Vector>
  rigid_body_modes(const dealii::DoFHandler<dim, dim> &dof_handler,
                   const Vector                       &layout);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// A load per reference area that keeps its direction.
#ifndef demold_solid_dead_traction_h
#define demold_solid_dead_traction_h

#include "base/plane_model.h"
#include "weak_form/term.h"

#include <deal.II/base/tensor.h>

#include <functional>
#include <memory>

namespace dealii
{
  template <int dim, int spacedim>
  class DoFHandler;
}

namespace demold
{
  /// Makes the term - int T(t) . du dA over the faces with @p boundary_id,
  /// where T [MPa] is a function of time [s] and dA the reference area. Its
  /// work enters the ledger as external, by the trapezoidal rule.
  template <int dim>
  std::unique_ptr<Term> make_dead_traction(
    const dealii::DoFHandler<dim, dim>                &dof_handler,
    const dealii::types::boundary_id                   boundary_id,
    const std::function<dealii::Tensor<1, 3>(double)> &traction,
    const PlaneModel                                  &plane);
} // namespace demold

#endif

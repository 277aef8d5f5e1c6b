// SPDX-License-Identifier: LGPL-2.1-or-later
// The rubber of one body as a term of the weak form.
#ifndef demold_solid_finite_strain_solid_h
#define demold_solid_finite_strain_solid_h

#include "base/plane_model.h"
#include "material/rubber_law.h"
#include "solid/element_kernel.h"
#include "weak_form/term.h"

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <functional>
#include <memory>
#include <string>

namespace dealii
{
  template <int dim, int spacedim>
  class DoFHandler;
}

namespace demold
{
  /// Chooses the law of a point: constant, or a function of the reference
  /// position (cure).
  using LawOfPoint = std::function<RubberLaw(const dealii::Point<3> &)>;

  /// Description of one rubber body.
  struct SolidDescription
  {
    dealii::types::material_id material_id = 0;
    std::string                element     = "q1p0"; ///< q1 | q1p0 | q2
    LawOfPoint                 law;
    bool                       uniform_law = true;

    /// State of cure [-] at a reference position, for pictures only.
    std::function<double(const dealii::Point<3> &)> f90 =
      [](const dealii::Point<3> &) { return 1.; };
    PlaneModel plane;
  };

  /// Makes the term g(u) = sum over cells of int P : dF dV for every cell of
  /// @p dof_handler with the material id of @p description that this rank
  /// owns (thesis eq. 2.66, first summand). The tangent is symmetric. The term
  /// is a CellResults too.
  template <int dim>
  std::unique_ptr<Term>
  make_solid_term(const dealii::DoFHandler<dim, dim> &dof_handler,
                  const SolidDescription             &description);
} // namespace demold

#endif

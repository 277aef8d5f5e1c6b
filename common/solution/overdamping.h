// SPDX-License-Identifier: LGPL-2.1-or-later
// Dashpots at all unknowns, along which a body slides down to an equilibrium.
#ifndef demold_solution_overdamping_h
#define demold_solution_overdamping_h

#include "weak_form/term.h"

namespace demold
{
  class WeakForm;

  /// f = c |K_ii| (u - u_n) at every unknown, K_ii the diagonal of the tangent
  /// at the start, c [-]: implicit steps down the slope of the energy (pseudo-
  /// transient continuation, Kelley and Keyes 1998). However steeply bonds
  /// soften, a large c makes the tangent definite and the step short; without
  /// a slope there is no force. Only for the length of a slide.
  class Overdamping : public Term
  {
  public:
    /// Takes the diagonal of the tangent of the last assembly of @p weak_form.
    explicit Overdamping(const WeakForm &weak_form);

    std::string name() const override;
    TermKind    kind() const override;
    bool        symmetric() const override;
    bool        assemble(const Configuration &, Assembler &) override;
    Energies    energies() const override;
    void        commit() override;
    void        revert() override;
    std::size_t history_bytes() const override;

    /// Before commit: books the work done on the dashpots by the forces of
    /// @p weak_form, -(f_n + f_{n+1})/2 . du, as regularisation.
    void account(const WeakForm &weak_form);

    double factor = 1.; ///< c [-]

  private:
    Vector stiffness; ///< |K_ii| [N/mm], zero at extra unknowns
    double committed_work = 0., work = 0.;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// A force on one displacement, a function of time.
#ifndef demold_network_nodal_load_h
#define demold_network_nodal_load_h

#include "weak_form/dead_load.h"
#include "weak_form/term.h"

#include <functional>

namespace demold
{
  /// - P(t) u for one unknown, which this rank owns if @p is_mine. Its work
  /// enters the ledger as external, by the trapezoidal rule.
  class NodalLoad
    : public Term
    , public DeadLoad
  {
  public:
    /// @p force [N] of the time [s].
    NodalLoad(const dealii::types::global_dof_index unknown,
              const bool                            is_mine,
              std::function<double(double)>         force);

    std::string name() const override;
    TermKind    kind() const override;
    bool        symmetric() const override;
    bool        assemble(const Configuration &, Assembler &) override;
    Energies    energies() const override;
    void        commit() override;
    void        revert() override;
    std::size_t history_bytes() const override;
    void        save(std::ostream &) const override;
    void        load(std::istream &) override;
    double      potential(double time) const override;

  private:
    const dealii::types::global_dof_index unknown;
    const bool                            is_mine;
    const std::function<double(double)>   force;

    double u    = 0.;                      ///< [mm] of the last assembly
    double work = 0., committed_work = 0.; ///< [mJ]
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// One mass on a spring whose support moves: what has a closed form.
#ifndef demold_tests_solution_strategies_spring_h
#define demold_tests_solution_strategies_spring_h

#include "weak_form/assembler.h"
#include "weak_form/weak_form.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace demold
{
  constexpr double mass = 2e-9, stiffness = 5.; // [t], [N/mm]
  constexpr double pull = 100.;                 // [mm/s]

  inline const double omega = std::sqrt(stiffness / mass); // [1/s]

  /// Spring between the mass, unknown 0, and its support, unknown 1.
  class Spring : public Term
  {
  public:
    std::string name() const override
    {
      return "spring";
    }

    TermKind kind() const override
    {
      return TermKind::bulk;
    }

    bool symmetric() const override
    {
      return true;
    }

    bool assemble(const Configuration &now, Assembler &assembler) override
    {
      const double           stretch = now.u(0) - now.u(1);
      dealii::Vector<double> r(2);
      r(0) = stiffness * stretch;
      r(1) = -r(0);
      dealii::FullMatrix<double> K(2, 2);
      K(0, 0) = K(1, 1) = stiffness;
      K(0, 1) = K(1, 0) = -stiffness;
      if (assembler.with_tangent())
        assembler.add({0, 1}, r, K);
      else
        assembler.add({0, 1}, r);
      stored = .5 * stiffness * stretch * stretch;
      return true;
    }

    Energies energies() const override
    {
      Energies e;
      e.stored = stored;
      return e;
    }

    void commit() override
    {}

    void revert() override
    {}

    std::size_t history_bytes() const override
    {
      return 0;
    }

    double stored = 0.;
  };

  /// The spring alone, its support pulled with constant velocity until @p stop
  /// [s]; the mass is a term still to be added.
  inline std::unique_ptr<WeakForm> pulled_spring(const double stop)
  {
    const auto all = dealii::complete_index_set(2);
    Supports   supports;
    supports.unknowns = {1};
    supports.values   = [stop](const double t, std::vector<double> &values) {
      values[0] = pull * std::min(t, stop);
    };
    auto form = std::make_unique<WeakForm>(
      DisplacementSpace{
        MPI_COMM_SELF,
        all,
        all,
        [](dealii::DynamicSparsityPattern          &pattern,
           const dealii::AffineConstraints<double> &constraints) {
          constraints.add_entries_local_to_global(
            std::vector<dealii::types::global_dof_index>{0, 1},
            pattern,
            false);
        }},
      supports);
    form->add(std::make_unique<Spring>());
    form->setup();
    return form;
  }

  /// [t] of the unknowns of @p form.
  inline Vector spring_masses(const WeakForm &form)
  {
    Vector m = form.new_vector();
    m(0)     = mass;
    m.compress(dealii::VectorOperation::insert);
    return m;
  }
} // namespace demold

#endif

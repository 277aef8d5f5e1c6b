// SPDX-License-Identifier: LGPL-2.1-or-later
// Dashpots at all unknowns, along which a body slides down to an equilibrium.
#include "solution/overdamping.h"

#include "weak_form/assembler.h"
#include "weak_form/weak_form.h"

#include <cmath>

namespace demold
{
  using namespace dealii;

  Overdamping::Overdamping(const WeakForm &weak_form)
    : stiffness(weak_form.new_vector())
  {
    for (const auto i : stiffness.locally_owned_elements())
      stiffness(i) = std::abs(weak_form.matrix.diag_element(i));
    stiffness.compress(VectorOperation::insert);
    weak_form.set_supports_to_zero(stiffness);
    weak_form.set_extra_to_zero(stiffness);
  }

  std::string Overdamping::name() const
  {
    return "overdamping";
  }

  TermKind Overdamping::kind() const
  {
    return TermKind::inertia;
  }

  bool Overdamping::symmetric() const
  {
    return true;
  }

  bool Overdamping::assemble(const Configuration &now, Assembler &assembler)
  {
    Assembler::Indices     index(1);
    dealii::Vector<double> r(1);
    FullMatrix<double>     K(1, 1);
    for (const auto i : stiffness.locally_owned_elements())
      {
        K(0, 0) = factor * stiffness(i);
        if (K(0, 0) == 0.)
          continue;
        index[0] = i;
        r(0)     = K(0, 0) * (now.u(i) - now.u_old(i));
        if (assembler.with_tangent())
          assembler.add(index, r, K);
        else
          assembler.add(index, r);
      }
    return true;
  }

  void Overdamping::account(const WeakForm &weak_form)
  {
    work = 0.;
    for (const auto i : stiffness.locally_owned_elements())
      if (stiffness(i) > 0.)
        work -= .5 * (weak_form.force(i) + weak_form.accepted_force(i)) *
                (weak_form.trial(i) - weak_form.accepted(i));
  }

  Energies Overdamping::energies() const
  {
    Energies e;
    e.regularisation = committed_work + work;
    return e;
  }

  void Overdamping::commit()
  {
    committed_work += work;
    work = 0.;
  }

  void Overdamping::revert()
  {
    work = 0.;
  }

  std::size_t Overdamping::history_bytes() const
  {
    return sizeof(double) * stiffness.locally_owned_size();
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// A force on one displacement, a function of time.
#include "network/nodal_load.h"

#include "weak_form/assembler.h"
#include "weak_form/vector_io.h"

namespace demold
{
  NodalLoad::NodalLoad(const dealii::types::global_dof_index unknown,
                       const bool                            is_mine,
                       std::function<double(double)>         force)
    : unknown(unknown)
    , is_mine(is_mine)
    , force(std::move(force))
  {}

  std::string NodalLoad::name() const
  {
    return "load";
  }

  TermKind NodalLoad::kind() const
  {
    return TermKind::bulk;
  }

  bool NodalLoad::symmetric() const
  {
    return true;
  }

  bool NodalLoad::assemble(const Configuration &now, Assembler &assembler)
  {
    if (!is_mine)
      return true;
    dealii::Vector<double> r(1);
    r(0) = -force(now.time);
    assembler.add({unknown}, r);
    u    = now.u(unknown);
    work = .5 * (force(now.time) + force(now.time - now.dt)) *
           (u - now.u_old(unknown));
    return true;
  }

  Energies NodalLoad::energies() const
  {
    Energies e;
    e.external = committed_work + work;
    return e;
  }

  void NodalLoad::commit()
  {
    committed_work += work;
    work = 0.;
  }

  void NodalLoad::revert()
  {
    work = 0.;
  }

  std::size_t NodalLoad::history_bytes() const
  {
    return 0;
  }

  void NodalLoad::save(std::ostream &out) const
  {
    write_values(out, {committed_work});
  }

  void NodalLoad::load(std::istream &in)
  {
    committed_work = read_values(in).at(0);
    work           = 0.;
  }

  double NodalLoad::potential(const double time) const
  {
    return is_mine ? force(time) * u : 0.;
  }
} // namespace demold

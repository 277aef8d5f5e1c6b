// SPDX-License-Identifier: LGPL-2.1-or-later
// Unknowns, supports and a list of terms: what a strategy solves.
#include "weak_form/weak_form.h"

#include "weak_form/assembler.h"
#include "weak_form/condensed_rows.h"
#include "weak_form/vector_io.h"

#include <deal.II/base/mpi.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  WeakForm::WeakForm(const DisplacementSpace &space, const Supports &supports)
    : space(space)
    , supports(supports)
  {}

  WeakForm::~WeakForm() = default;

  Term &WeakForm::add(std::unique_ptr<Term> term)
  {
    AssertThrow(!is_set_up || term->extra_unknown_owners().empty(),
                ExcMessage("a term with extra unknowns joins before setup()"));
    terms.push_back(std::move(term));
    return *terms.back();
  }

  void WeakForm::remove(const Term &term)
  {
    const auto position =
      std::find_if(terms.begin(), terms.end(), [&](const auto &t) {
        return t.get() == &term;
      });
    AssertThrow(position != terms.end(), ExcMessage("no such term"));
    Energies last = term.energies();
    last.stored = last.kinetic = 0.; // these leave with the term
    retired += last;
    terms.erase(position);
  }

  void WeakForm::setup()
  {
    const unsigned int rank =
      Utilities::MPI::this_mpi_process(space.communicator);
    const types::global_dof_index n_displacements = space.owned.size();

    std::vector<unsigned int> owners;
    for (const auto &term : terms)
      {
        term->set_first_extra_unknown(n_displacements + owners.size());
        for (const unsigned int owner : term->extra_unknown_owners())
          owners.push_back(owner);
      }
    n_extra = owners.size();

    owned.clear();
    owned.set_size(n_displacements + n_extra);
    owned.add_indices(space.owned);
    relevant = IndexSet(owned.size());
    relevant.add_indices(space.relevant);
    for (unsigned int i = 0; i < n_extra; ++i)
      if (owners[i] == rank)
        owned.add_index(n_displacements + i);
    for (const auto &term : terms)
      term->needed_unknowns(relevant);
    relevant.add_indices(owned);
    owned.compress();
    relevant.compress();

    constraints.reinit(relevant);
    for (const auto i : supports.unknowns)
      if (relevant.is_element(i))
        constraints.add_line(i);
    constraints.close();
    prescribed.assign(supports.unknowns.size(), 0.);

    for (Vector *v : {&trial,
                      &accepted,
                      &previous_increment,
                      &force,
                      &accepted_force,
                      &bulk,
                      &interface,
                      &inertia,
                      &residual,
                      &accepted_bulk,
                      &right_hand_side})
      v->reinit(owned, space.communicator);
    for (Vector *v : {&ghosted_trial, &ghosted_accepted})
      v->reinit(owned, relevant, space.communicator);
    build_pattern();
    is_set_up = true;
  }

  void WeakForm::build_pattern()
  {
    DynamicSparsityPattern pattern(owned.size(), owned.size(), relevant);
    space.add_cell_couplings(pattern, constraints);
    for (const auto &term : terms)
      term->add_couplings(pattern, constraints);
    for (const auto i : owned)
      pattern.add(i, i);
    SparsityTools::distribute_sparsity_pattern(pattern,
                                               owned,
                                               space.communicator,
                                               relevant);
    matrix.reinit(owned, owned, pattern, space.communicator);
    ++n_patterns;
  }

  Vector WeakForm::new_vector() const
  {
    Vector v;
    v.reinit(owned, space.communicator);
    return v;
  }

  types::global_dof_index WeakForm::n_unknowns() const
  {
    return owned.size();
  }

  void WeakForm::begin_increment(const double time, const double extrapolation)
  {
    new_time        = time;
    trial           = accepted;
    is_extrapolated = extrapolation != 0.;
    if (is_extrapolated)
      trial.add(extrapolation, previous_increment);
    supports.values(time, prescribed);
  }

  void WeakForm::move_to(const double time)
  {
    new_time = time;
    supports.values(time, prescribed);
    set_trial_at_supports();
  }

  void WeakForm::set_trial_at_supports()
  {
    for (std::size_t k = 0; k < supports.unknowns.size(); ++k)
      if (owned.is_element(supports.unknowns[k]))
        trial(supports.unknowns[k]) = prescribed[k];
    trial.compress(VectorOperation::insert);
  }

  Configuration WeakForm::configuration(const unsigned int iteration) const
  {
    return {ghosted_trial,
            ghosted_accepted,
            new_time,
            new_time - accepted_time,
            iteration,
            is_extrapolated && iteration == 0,
            std::max(0., new_time - latest_time)};
  }

  bool WeakForm::prescribe_increments()
  {
    bool any = false;
    for (std::size_t k = 0; k < supports.unknowns.size(); ++k)
      {
        const auto i = supports.unknowns[k];
        if (!relevant.is_element(i))
          continue;
        const double jump = prescribed[k] - ghosted_trial(i);
        constraints.set_inhomogeneity(i, jump);
        any = any || jump != 0.;
      }
    return Utilities::MPI::max(any ? 1 : 0, space.communicator) == 1;
  }

  bool WeakForm::assemble(const bool with_tangent, const unsigned int iteration)
  {
    ghosted_trial           = trial;
    const Configuration now = configuration(iteration);

    bool new_couplings = false;
    for (const auto &term : terms)
      {
        term->prepare(now);
        new_couplings = new_couplings || term->couplings_changed();
      }
    if (Utilities::MPI::max(new_couplings ? 1 : 0, space.communicator) == 1)
      build_pattern();

    const bool inhomogeneous = with_tangent && prescribe_increments();
    for (Vector *v : {&bulk, &interface, &inertia, &right_hand_side})
      *v = 0.;
    if (with_tangent)
      matrix = 0.;

    bool admissible = true;
    for (const auto &term : terms)
      {
        Vector         &target = term->kind() == TermKind::bulk      ? bulk :
                                 term->kind() == TermKind::interface ? interface :
                                                                       inertia;
        SystemAssembler assembler(constraints,
                                  target,
                                  right_hand_side,
                                  with_tangent ? &matrix : nullptr,
                                  inhomogeneous);
        if (term->kind() == TermKind::bulk)
          assembler.weight = bulk_weight;
        admissible = term->assemble(now, assembler) && admissible;
      }
    for (Vector *v : {&bulk, &interface, &inertia, &right_hand_side})
      v->compress(VectorOperation::add);
    if (with_tangent)
      matrix.compress(VectorOperation::add);

    residual = inertia;
    residual += interface;
    residual.add(bulk_weight, bulk, 1. - bulk_weight, accepted_bulk);
    CondensedRows rows(constraints,
                       residual,
                       interface,
                       right_hand_side,
                       with_tangent ? &matrix : nullptr);
    for (const auto &term : terms)
      term->condense(now, rows);
    for (Vector *v : {&residual, &right_hand_side, &interface})
      v->compress(VectorOperation::insert);
    force = bulk;
    force += interface;

    Vector free(residual);
    set_supports_to_zero(free);
    right_hand_side -= free;
    return Utilities::MPI::min(admissible ? 1 : 0, space.communicator) == 1;
  }

  void WeakForm::set_supports_to_zero(Vector &v) const
  {
    for (const auto i : supports.unknowns)
      if (owned.is_element(i))
        v(i) = 0.;
    v.compress(VectorOperation::insert);
  }

  void WeakForm::set_extra_to_zero(Vector &v) const
  {
    for (const auto i : owned)
      if (i >= space.owned.size())
        v(i) = 0.;
    v.compress(VectorOperation::insert);
  }

  void WeakForm::update(const Vector &du, const double factor)
  {
    trial.add(factor, du);
    if (factor == 1.) // supports exactly, whatever the linear solver left
      set_trial_at_supports();
  }

  double WeakForm::work_of_supports() const
  {
    double work = 0.;
    for (const auto i : supports.unknowns)
      if (owned.is_element(i))
        work += .5 * (accepted_force(i) + force(i)) * (trial(i) - accepted(i));
    return work;
  }

  void WeakForm::accept()
  {
    accepted_external += work_of_supports();
    previous_increment = trial;
    previous_increment -= accepted;
    accepted         = trial;
    ghosted_accepted = trial;
    accepted_force   = force;
    accepted_bulk    = bulk;
    accepted_time    = new_time;
    latest_time      = std::max(latest_time, new_time);
    for (const auto &term : terms)
      term->commit();
  }

  void WeakForm::reject()
  {
    new_time = accepted_time;
    trial    = accepted;
    force    = accepted_force;
    for (const auto &term : terms)
      term->revert();
  }

  void WeakForm::set_bulk_weight(const double weight)
  {
    bulk_weight = weight;
  }

  ResidualNorms WeakForm::residual_norms() const
  {
    Vector free(residual);
    set_supports_to_zero(free);
    const auto    n_displacements = space.owned.size();
    ResidualNorms norms;
    double        squares[2] = {0., 0.};
    for (const auto i : owned)
      squares[i < n_displacements ? 0 : 1] += free(i) * free(i);
    norms.free = std::sqrt(Utilities::MPI::sum(squares[0], space.communicator));
    norms.extra =
      std::sqrt(Utilities::MPI::sum(squares[1], space.communicator));
    norms.scale =
      std::max({bulk.l2_norm(), interface.l2_norm(), inertia.l2_norm()});
    norms.unknowns = trial.l2_norm();
    return norms;
  }

  double WeakForm::work_of_residual(const Vector &du) const
  {
    Vector free(residual);
    set_supports_to_zero(free);
    return free * du;
  }

  unsigned int WeakForm::n_state_changes() const
  {
    unsigned int n = 0;
    for (const auto &term : terms)
      n += term->n_state_changes();
    return Utilities::MPI::sum(n, space.communicator);
  }

  bool WeakForm::has_settled() const
  {
    const bool settled =
      std::all_of(terms.begin(), terms.end(), [](const auto &t) {
        return t->has_settled();
      });
    return Utilities::MPI::min(settled ? 1 : 0, space.communicator) == 1;
  }

  Energies WeakForm::energies() const
  {
    Energies share = retired;
    for (const auto &term : terms)
      share += term->energies();
    share.external += accepted_external + work_of_supports();
    auto       sums = share.as_array();
    const auto mine = sums;
    Utilities::MPI::sum(ArrayView<const double>(mine.data(), mine.size()),
                        space.communicator,
                        ArrayView<double>(sums.data(), sums.size()));
    return Energies::from_array(sums);
  }

  bool WeakForm::symmetric() const
  {
    return std::all_of(terms.begin(), terms.end(), [](const auto &t) {
      return t->symmetric();
    });
  }

  void WeakForm::save(std::ostream &out) const
  {
    for (const Vector *v : {&accepted_force, &accepted_bulk})
      write_owned(out, *v);
    write_owned(out, accepted);
    write_owned(out, previous_increment);
    write_values(out, {accepted_time, accepted_external, latest_time});
    const auto kept = retired.as_array();
    write_values(out, {kept.begin(), kept.end()});
    for (const auto &term : terms)
      term->save(out);
  }

  void WeakForm::load(std::istream &in)
  {
    for (Vector *v : {&accepted_force, &accepted_bulk})
      read_owned(in, *v);
    read_owned(in, accepted);
    read_owned(in, previous_increment);
    ghosted_accepted  = accepted;
    const auto values = read_values(in);
    accepted_time = new_time                     = values.at(0);
    accepted_external                            = values.at(1);
    latest_time                                  = values.at(2);
    const auto                              kept = read_values(in);
    std::array<double, Energies::n_entries> entries;
    std::copy_n(kept.begin(), entries.size(), entries.begin());
    retired = Energies::from_array(entries);
    trial   = accepted;
    force   = accepted_force;
    for (const auto &term : terms)
      term->load(in);
  }
} // namespace demold

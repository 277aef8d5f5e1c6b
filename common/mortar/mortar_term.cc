// SPDX-License-Identifier: LGPL-2.1-or-later
// Life of the mortar term: start, increments, checkpoints.
#include "mortar/mortar_term.h"

#include "weak_form/assembler.h"

#include <deal.II/base/timer.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace demold
{
  using namespace dealii;

  namespace
  {
    PairOptions pair_options(const InterfaceDescription &description)
    {
      PairOptions        options;
      const unsigned int order = description.quadrature_order;
      options.triangle_points  = order <= 2 ? 3 : order <= 4 ? 6 : 7;
      options.line_points      = order <= 3 ? 2 : 3;
      options.plane            = description.plane;
      return options;
    }

    TractionResolvent make_resolvent(const InterfaceDescription &description,
                                     const double                height)
    {
      TractionResolvent resolvent;
      resolvent.friction = description.friction;
      if (description.adhesion)
        {
          resolvent.adhesion = *description.adhesion;
          resolvent.adhesion->softening =
            rigid_softening(description.adhesion->softening);
        }
      // chosen here, theory C8
      resolvent.penalty = std::max(2. * resolvent.smallest_penalty(),
                                   10. * description.stiffness / height);
      return resolvent;
    }
  } // namespace

  MortarTerm::MortarTerm(
    BoundarySurface                                     slave,
    Master                                              master,
    const InterfaceDescription                         &description,
    const IndexSet                                     &owned,
    const std::function<bool(types::global_dof_index)> &is_held,
    MPI_Comm                                            communicator)
    : description(description)
    , communicator(communicator)
    , surfaces(std::move(slave),
               std::move(master),
               description,
               owned,
               communicator)
    , mortar(surfaces, pair_options(description), description.dual_multipliers)
    , resolvent(make_resolvent(description, surfaces.mean_height()))
    , stiffness(resolvent.penalty)
    , components(surfaces.dim() == 2 ? std::vector<unsigned int>{0, 1} :
                                       std::vector<unsigned int>{0, 1, 2})
  {
    if (description.augmentation > 0.)
      resolvent.penalty = description.augmentation;
    const std::size_t n = surfaces.own_points().size();
    committed.resize(n);
    frozen.resize(n);
    slip_rows.resize(n);
    newton_memory.resize(n);
    inputs.resize(n);
    just_closed.assign(n, false);
    last_number.assign(n, state_free);
    found.resize(n);
    eliminated.resize(n);
    find_compliance(is_held);
    start_points();
    trial = committed;
  }

  std::string MortarTerm::name() const
  {
    return "contact";
  }

  TermKind MortarTerm::kind() const
  {
    return TermKind::interface;
  }

  bool MortarTerm::symmetric() const
  {
    return false;
  }

  std::vector<unsigned int> MortarTerm::extra_unknown_owners() const
  {
    std::vector<unsigned int> owners;
    if (is_condensed())
      return owners;
    for (const unsigned int rank : surfaces.owners())
      owners.insert(owners.end(), surfaces.dim(), rank);
    return owners;
  }

  void MortarTerm::set_first_extra_unknown(const types::global_dof_index first)
  {
    first_multiplier = first;
  }

  types::global_dof_index
  MortarTerm::first_unknown_of(const unsigned int point) const
  {
    return first_multiplier +
           static_cast<types::global_dof_index>(surfaces.dim()) * point;
  }

  types::global_dof_index
  MortarTerm::first_unknown(const unsigned int own) const
  {
    return first_unknown_of(surfaces.own_points()[own]);
  }

  void MortarTerm::needed_unknowns(IndexSet &set) const
  {
    set.add_indices(surfaces.all_unknowns(set.size()));
    for (const Leaning &on : leaning)
      for (const unsigned int point : on.points)
        set.add_range(first_unknown_of(point),
                      first_unknown_of(point) + surfaces.dim());
  }

  void
  MortarTerm::add_couplings(DynamicSparsityPattern          &pattern,
                            const AffineConstraints<double> &constraints) const
  {
    for (unsigned int own = 0; own < committed.size(); ++own)
      {
        std::set<unsigned int> nodes(frozen[own].row.nodes.begin(),
                                     frozen[own].row.nodes.end());
        nodes.insert(slip_rows[own].nodes.begin(), slip_rows[own].nodes.end());
        if (!frozen[own].row.nodes.empty())
          surfaces.add_master_nodes(frozen[own].anchor.facet, nodes);
        for (const unsigned int face : point(own).facets)
          surfaces.add_nodes_around(face, nodes);
        Assembler::Indices indices;
        for (const unsigned int node : nodes)
          if (!surfaces.is_rigid(node))
            for (unsigned int d = 0; d < surfaces.dim(); ++d)
              indices.push_back(surfaces.node(node).unknowns[d]);
        for (unsigned int d = 0; !is_condensed() && d < surfaces.dim(); ++d)
          {
            indices.push_back(first_unknown(own) + d);
            for (const unsigned int point : leaning[own].points)
              indices.push_back(first_unknown_of(point) + d);
          }
        constraints.add_entries_local_to_global(indices, pattern, false);
      }
  }

  bool MortarTerm::couplings_changed() const
  {
    return surfaces.has_new_candidates() && !surfaces.master().is_rigid();
  }

  void MortarTerm::prepare(const Configuration &state)
  {
    Timer timer;
    surfaces.move_to(state);
    if (state.iteration == 0)
      {
        last_dt = state.elapsed;
        for (unsigned int own = 0; own < committed.size(); ++own)
          {
            newton_memory[own]         = NewtonMemory();
            newton_memory[own].contact = committed[own].closed ?
                                           ContactStatus::closed :
                                           ContactStatus::open;
            eliminated[own].restart(committed[own].traction);
          }
      }
    seconds += timer.wall_time();
  }

  void MortarTerm::commit()
  {
    for (unsigned int own = 0; own < committed.size(); ++own)
      just_closed[own] = trial[own].closed && !committed[own].closed;
    committed        = trial;
    largest_accepted = std::max(largest_accepted, largest_found);
    keep_slip_rows();
    if (description.adhesion && description.adhesion->rest_efficiency > 0.)
      bond_again();
    const double stored = now.stored;
    committed_work += now;
    committed_work.stored = stored;
    revert();
  }

  void MortarTerm::revert()
  {
    on_path.clear();
    trial      = committed;
    increment  = Increment();
    now        = Energies();
    now.stored = committed_work.stored;
  }
} // namespace demold

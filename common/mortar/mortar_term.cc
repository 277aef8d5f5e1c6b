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
    /// Compliances over 1/c_N of multipliers that their constraints alone
    /// leave undetermined. Gaps are wrong by this share of lambda/c_N.
    constexpr double vanishing_compliance = 1e-6;
    /// A standard multiplier acts on the nodes around its own too. Where its
    /// node has a support or another multiplier, and they have not, constraints
    /// outnumber displacements: a stiffer one would tear at the neighbours.
    constexpr double neighbour_compliance = 1.;

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
      resolvent.penalty = description.augmentation;
      if (resolvent.penalty <= 0.) // chosen here, theory C8
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
  {
    const std::size_t n = surfaces.own_points().size();
    committed.resize(n);
    frozen.resize(n);
    slip_rows.resize(n);
    newton_memory.resize(n);
    just_closed.assign(n, false);
    last_number.assign(n, state_free);
    found.resize(n);
    eliminated.resize(n);
    find_compliance(is_held);
    start_points();
    trial = committed;
  }

  void MortarTerm::find_compliance(
    const std::function<bool(types::global_dof_index)> &is_held)
  {
    std::vector<unsigned int> points_at_node(surfaces.n_slave_nodes(), 0);
    for (const SlavePoint &point : surfaces.points())
      ++points_at_node[point.node];
    for (unsigned int own = 0; own < committed.size(); ++own)
      {
        std::set<unsigned int> around;
        for (const unsigned int face : point(own).facets)
          surfaces.add_slave_nodes(face, around);
        compliance.emplace_back();
        free.emplace_back();
        driven.push_back(false);
        shared.push_back(points_at_node[point(own).node] > 1);
        for (unsigned int d = 0; d < surfaces.dim(); ++d)
          if (!is_held(surfaces.node(point(own).node).unknowns[d]))
            free[own].push_back(d);
        for (unsigned int d = 0; d < surfaces.dim(); ++d)
          {
            const auto held = [&](const unsigned int node) {
              return is_held(surfaces.node(node).unknowns[d]);
            };
            const bool all_held =
              std::all_of(around.begin(), around.end(), held);
            driven[own] = driven[own] || all_held;
            if (all_held)
              compliance[own][d] = vanishing_compliance;
            else if (held(point(own).node) || shared[own])
              compliance[own][d] = description.dual_multipliers ?
                                     vanishing_compliance :
                                     neighbour_compliance;
          }
        if (is_condensed() && !has_own_rows(own))
          for (unsigned int d = 0; d < surfaces.dim(); ++d)
            compliance[own][d] =
              std::max(compliance[own][d], vanishing_compliance);
        compliance[own] /= resolvent.penalty;
      }
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
  MortarTerm::first_unknown(const unsigned int own) const
  {
    return first_multiplier +
           static_cast<types::global_dof_index>(surfaces.dim()) *
             surfaces.own_points()[own];
  }

  void MortarTerm::needed_unknowns(IndexSet &set) const
  {
    set.add_indices(surfaces.all_unknowns(set.size()));
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
          indices.push_back(first_unknown(own) + d);
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
        newton_memory.assign(newton_memory.size(), NewtonMemory());
        for (unsigned int own = 0; own < committed.size(); ++own)
          eliminated[own].restart(committed[own].traction);
      }
    seconds += timer.wall_time();
  }

  void MortarTerm::commit()
  {
    for (unsigned int own = 0; own < committed.size(); ++own)
      just_closed[own] = trial[own].closed && !committed[own].closed;
    committed = trial;
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
    trial      = committed;
    increment  = Increment();
    now        = Energies();
    now.stored = committed_work.stored;
  }
} // namespace demold

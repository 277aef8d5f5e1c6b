// SPDX-License-Identifier: LGPL-2.1-or-later
// Life of the node-to-segment term: start, increments, checkpoints.
#include "contact/node_to_segment.h"

#include "weak_form/vector_io.h"

#include <deal.II/base/timer.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <cmath>

namespace demold
{
  using namespace dealii;

  NodeToSegment::NodeToSegment(BoundarySurface             slave,
                               Master                      master,
                               const InterfaceDescription &description,
                               const IndexSet             &owned,
                               MPI_Comm                    communicator)
    : description(description)
    , law(description.adhesion)
    , communicator(communicator)
    , surfaces(std::move(slave), std::move(master), description, owned)
  {
    const unsigned int n = surfaces.n_points();
    committed.contact.resize(n);
    if (description.friction > 0.)
      committed.friction.resize(n);
    if (description.adhesion)
      committed.bond.resize(n);
    may_bond.assign(n, false);
    just_closed.assign(n, false);
    last_state.assign(n, state_free);
    last_bond_status.assign(n, AdhesionStatus::separated);
    for (unsigned int p = 0; p < n; ++p)
      start_point(p);
    trial = committed;
  }

  void NodeToSegment::start_point(const unsigned int p)
  {
    const Point<3> &x = surfaces.x(p);
    may_bond[p]       = description.adhesion && description.bonds_on_touch &&
                  description.bonded(x);
    const auto found = surfaces.nearest(p, numbers::invalid_unsigned_int);
    if (!found)
      return;
    ContactHistory &contact = committed.contact[p];
    contact.closed          = found->gap <= touching_gap;
    contact.gap             = found->gap;
    contact.last_facet      = found->facet;

    if (!description.adhesion || description.bonds_on_touch ||
        !description.bonded(x) ||
        std::abs(found->gap) > .5 * description.adhesion->rupture_gap())
      return;
    BondHistory &bond = committed.bond[p];
    bond.bonded       = true;
    const auto foot   = surfaces.bond_foot(p, *found);
    bond.anchor       = surfaces.master().set_anchor(foot.facet, foot.xi, x);
    bond.status       = AdhesionStatus::adhering;
  }

  std::string NodeToSegment::name() const
  {
    return "contact";
  }

  TermKind NodeToSegment::kind() const
  {
    return TermKind::interface;
  }

  bool NodeToSegment::symmetric() const
  {
    if (description.friction > 0.)
      return false;
    return !description.adhesion ||
           (description.adhesion->symmetric() && surfaces.master().is_rigid());
  }

  void NodeToSegment::needed_unknowns(IndexSet &set) const
  {
    set.add_indices(surfaces.all_unknowns(set.size()));
  }

  void NodeToSegment::add_couplings(
    DynamicSparsityPattern          &pattern,
    const AffineConstraints<double> &constraints) const
  {
    for (unsigned int p = 0; p < surfaces.n_points(); ++p)
      {
        std::vector<unsigned int> facets;
        if (!committed.bond.empty() && committed.bond[p].bonded)
          facets.push_back(committed.bond[p].anchor.facet);
        if (!committed.friction.empty() && committed.friction[p].active)
          facets.push_back(committed.friction[p].stick.facet);
        constraints.add_entries_local_to_global(
          surfaces.couplings(p, facets).indices,
          pattern,
          false);
      }
  }

  bool NodeToSegment::couplings_changed() const
  {
    return surfaces.has_new_candidates() && !surfaces.master().is_rigid();
  }

  void NodeToSegment::prepare(const Configuration &state)
  {
    Timer timer;
    surfaces.move_to(state, communicator);
    if (state.iteration == 0)
      last_dt = state.elapsed;
    if (law && law->viscous_time > 0.)
      law = law->over(state.elapsed);
    seconds += timer.wall_time();
  }

  bool NodeToSegment::assemble(const Configuration &state, Assembler &assembler)
  {
    Timer timer;
    now           = Energies();
    increment     = Increment();
    state_changes = 0;
    trial         = committed;
    for (unsigned int p = 0; p < surfaces.n_points(); ++p)
      {
        if (!committed.bond.empty() && committed.bond[p].bonded)
          assemble_bond(state, assembler, p);
        const int contact_state = assemble_contact(state, assembler, p);
        count_change(p,
                     trial.holds(p) && contact_state != state_slip ?
                       static_cast<int>(trial.bond[p].status) :
                       contact_state);
      }
    seconds += timer.wall_time();
    return true;
  }

  void NodeToSegment::commit()
  {
    for (unsigned int p = 0; p < surfaces.n_points(); ++p)
      just_closed[p] = trial.contact[p].closed && !committed.contact[p].closed;
    committed = trial;
    if (description.adhesion && description.bonds_on_touch)
      bond_on_touch();
    if (description.adhesion && description.adhesion->rest_efficiency > 0.)
      bond_again();
    const double stored = now.stored;
    committed_work += now;
    committed_work.stored = stored;
    revert();
  }

  /// The anchor lies on the master, not where the penalty lets the point
  /// penetrate: the bond pulls from where the pressure ends.
  void NodeToSegment::bond_on_touch()
  {
    for (unsigned int p = 0; p < surfaces.n_points(); ++p)
      {
        const auto  &pairing = surfaces.last_pairing(p);
        BondHistory &bond    = committed.bond[p];
        if (bond.bonded || !may_bond[p] || !pairing ||
            !(committed.contact[p].closed && committed.contact[p].gap < 0.))
          continue;
        const Master               &master = surfaces.master();
        const SurfacePair::BondFoot foot   = surfaces.bond_foot(p, *pairing);
        bond.bonded                        = true;
        bond.anchor                        = master.drag_anchor(
          foot.facet,
          contact_kinematics(*pairing, surfaces.x(p), master.surface).x_m);
        bond.state.gap = surfaces.x(p) - master.place(bond.anchor).x;
        bond.status    = AdhesionStatus::adhering;
      }
  }

  void NodeToSegment::bond_again()
  {
    for (unsigned int p = 0; p < surfaces.n_points(); ++p)
      {
        BondHistory          &bond    = committed.bond[p];
        const ContactHistory &contact = committed.contact[p];
        if (!bond.bonded || bond.status != AdhesionStatus::separated)
          continue;
        bond.state =
          description.adhesion->rested(bond.state,
                                       contact.closed ?
                                         -description.penalty * contact.gap :
                                         0.,
                                       last_dt);
        const auto &pairing = surfaces.last_pairing(p);
        if (bond.state.kappa > 0. || !pairing)
          continue;
        const auto foot = surfaces.bond_foot(p, *pairing);
        bond.anchor =
          surfaces.master().set_anchor(foot.facet, foot.xi, surfaces.x(p));
        bond.status          = AdhesionStatus::adhering;
        bond.separation_time = -1.;
        bond.force           = Tensor<1, 3>();
      }
  }

  void NodeToSegment::revert()
  {
    driven.clear();
    trial      = committed;
    increment  = Increment();
    now        = Energies();
    now.stored = committed_work.stored;
  }

  std::size_t NodeToSegment::history_bytes() const
  {
    return committed.bytes() + trial.bytes();
  }

  void NodeToSegment::save(std::ostream &out) const
  {
    HistoryWriter  writer;
    PointHistories histories = committed; // serialize() wants to write too
    histories.serialize(writer);
    for (const double x : {committed_work.friction,
                           committed_work.impact,
                           committed_work.external,
                           committed_work.stored,
                           committed_work.regularisation})
      writer.values.push_back(x);
    write_values(out, writer.values);
  }

  void NodeToSegment::load(std::istream &in)
  {
    const std::vector<double> values = read_values(in);
    HistoryReader             reader{values};
    committed.serialize(reader);
    reader &committed_work.friction &committed_work.impact &committed_work
      .external &committed_work.stored &committed_work.regularisation;
    revert();
  }
} // namespace demold

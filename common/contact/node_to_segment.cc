// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact, friction and adhesion between slave nodes and master facets.
#include "contact/node_to_segment.h"

#include "weak_form/assembler.h"
#include "weak_form/vector_io.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Newton iterations after which pairings and states are kept, so that no
    /// active set can cycle (theory C.3).
    constexpr unsigned int freeze_after = 8;

    /// Iterations, counted from there, in which a softening bond shows Newton
    /// a small positive stiffness: this share of its secant. Where the bond
    /// softens faster than the rubber gives way, the true tangent leads back
    /// to the intact bond and round in circles; with this one the gap grows by
    /// the ratio of both stiffnesses until the bond has let go: a jump.
    constexpr unsigned int jump_iterations = 40;
    constexpr double       jump_stiffness  = .02;

    /// Decohesion of one increment may cost this share of G_c A of the nodes
    /// that let go (theory D.4, step rule).
    constexpr double tolerated_decohesion = .1;

    /// Gap [mm] that counts as touching: surfaces that meet at the start hold
    /// each other in the first iteration.
    constexpr double touching = 1e-10;

    /// Cosine of 40 degrees: facets that meet more smoothly are one surface.
    constexpr double smooth_cosine = .766;

    /// States of theory C.5 for points without pressure and bond.
    constexpr int state_contact = 4, state_slip = 5, state_free = 6;

    /// Unknowns of a list of nodes and where each came from in local arrays
    /// with three entries per node.
    struct LocalUnknowns
    {
      Assembler::Indices        indices;
      std::vector<unsigned int> entries;

      void add(const BoundarySurface::Node &node,
               const unsigned int           position,
               const unsigned int           dim)
      {
        for (unsigned int d = 0; d < dim; ++d)
          {
            indices.push_back(node.unknowns[d]);
            entries.push_back(3 * position + d);
          }
      }
    };

    /// Adds R and K (three entries per node, any array type) times @p area.
    template <typename VectorLike, typename MatrixLike>
    void scatter(Assembler &          assembler,
                 const LocalUnknowns &local,
                 const double         area,
                 const VectorLike &   R,
                 const MatrixLike &   K)
    {
      const unsigned int     n = local.indices.size();
      dealii::Vector<double> r(n);
      for (unsigned int i = 0; i < n; ++i)
        r(i) = area * R[local.entries[i]];
      if (!assembler.with_tangent())
        {
          assembler.add(local.indices, r);
          return;
        }
      FullMatrix<double> k(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          k(i, j) = area * K[local.entries[i]][local.entries[j]];
      assembler.add(local.indices, r, k);
    }

    Point<3> current(const BoundarySurface::Node &node,
                     const Vector &               u,
                     const unsigned int           dim)
    {
      Point<3> x = node.X;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] += u(node.unknowns[d]);
      return x;
    }
  } // namespace

  NodeToSegment::NodeToSegment(BoundarySurface             slave_,
                               Master                      master_,
                               const InterfaceDescription &description,
                               const IndexSet &            owned,
                               MPI_Comm                    communicator)
    : slave(std::move(slave_))
    , slave_surface(slave.facets, slave.positions())
    , master(std::move(master_))
    , description(description)
    , all_unknowns(owned.size())
    , communicator(communicator)
    , search(description.search_distance, description.skin)
  {
    for (const SlavePoint &point :
         collect_slave_points(slave, slave_surface, description.plane))
      if (owned.is_element(slave.nodes[point.node].unknowns[0]))
        points.push_back(point);
    for (const auto *nodes : {&slave.nodes, &master.nodes})
      for (const BoundarySurface::Node &node : *nodes)
        for (const auto i : node.unknowns)
          all_unknowns.add_index(i);

    contact.resize(points.size());
    if (description.friction > 0.)
      friction.resize(points.size());
    just_closed.assign(points.size(), false);
    last_state.assign(points.size(), state_free);
    last_pairing.resize(points.size());
    for (const SlavePoint &point : points)
      x_points.push_back(slave.nodes[point.node].X);
    search.rebuild(master.surface, x_points);
    close_initially();
    if (description.adhesion)
      bond_initially();
    contact_trial  = contact;
    friction_trial = friction;
    bond_trial     = bond;
  }

  void NodeToSegment::close_initially()
  {
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        const auto found =
          find_contact(x_points[p],
                       slave_normal(points[p], slave_surface),
                       master.surface,
                       search.candidates(p),
                       numbers::invalid_unsigned_int,
                       {description.search_distance, points[p].depth});
        if (!found)
          continue;
        contact[p].closed     = found->gap <= touching;
        contact[p].gap        = found->gap;
        contact[p].last_facet = found->facet;
      }
  }

  void NodeToSegment::bond_initially()
  {
    bond.resize(points.size());
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        const Point<3> x = x_points[p];
        const auto     found =
          find_contact(x,
                       slave_normal(points[p], slave_surface),
                       master.surface,
                       search.candidates(p),
                       numbers::invalid_unsigned_int,
                       {description.search_distance, points[p].depth});
        if (!found || !description.bonded(x) ||
            found->kind != ContactCase::face ||
            std::abs(found->gap) > .5 * description.adhesion->rupture_gap())
          continue;
        bond[p].bonded = true;
        bond[p].anchor = master.set_anchor(found->facet, found->xi, x);
        bond[p].status = AdhesionStatus::adhering;
      }
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
           (description.adhesion->symmetric() && master.is_rigid());
  }

  void NodeToSegment::needed_unknowns(IndexSet &set) const
  {
    set.add_indices(all_unknowns);
  }

  void NodeToSegment::add_couplings(
    DynamicSparsityPattern &         pattern,
    const AffineConstraints<double> &constraints) const
  {
    const unsigned int dim = slave_surface.n_dimensions();
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        LocalUnknowns local;
        local.add(slave.nodes[points[p].node], 0, dim);
        if (!master.is_rigid())
          {
            std::vector<unsigned int> facets = search.candidates(p);
            if (!bond.empty() && bond[p].bonded)
              facets.push_back(bond[p].anchor.facet);
            if (!friction.empty() && friction[p].active)
              facets.push_back(friction[p].stick.facet);
            if (last_pairing[p]) // frozen, it may have left the candidates
              facets.push_back(last_pairing[p]->facet);
            std::set<unsigned int> nodes;
            for (const unsigned int f : facets)
              for (unsigned int i = 0; i < master.surface.facet(f).n_nodes; ++i)
                nodes.insert(master.surface.facet(f).nodes[i]);
            for (const unsigned int i : nodes)
              local.add(master.nodes[i], 0, dim);
          }
        constraints.add_entries_local_to_global(local.indices, pattern, false);
      }
  }

  bool NodeToSegment::couplings_changed() const
  {
    return search_was_rebuilt && !master.is_rigid();
  }

  void NodeToSegment::prepare(const Configuration &state)
  {
    Timer              timer;
    const unsigned int dim = slave_surface.n_dimensions();
    if (master.is_rigid())
      master.move_to(state.time);
    else
      {
        std::vector<Point<3>> x;
        for (const auto &node : master.nodes)
          x.push_back(current(node, state.u, dim));
        master.surface.set_positions(x);
      }
    std::vector<Point<3>> x_slave;
    for (const auto &node : slave.nodes)
      x_slave.push_back(current(node, state.u, dim));
    slave_surface.set_positions(x_slave);
    for (unsigned int p = 0; p < points.size(); ++p)
      x_points[p] = x_slave[points[p].node];

    search_was_rebuilt =
      Utilities::MPI::max(search.is_outdated(master.surface, x_points) ? 1 : 0,
                          communicator) == 1;
    if (search_was_rebuilt)
      search.rebuild(master.surface, x_points);
    if (state.iteration == 0)
      {
        std::fill(last_pairing.begin(), last_pairing.end(), std::nullopt);
        last_dt = state.dt;
      }
    seconds += timer.wall_time();
  }

  bool NodeToSegment::assemble(const Configuration &state, Assembler &assembler)
  {
    Timer timer;
    now           = Increment();
    state_changes = 0;
    contact_trial = contact;
    friction_trial = friction;
    bond_trial     = bond;
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        if (!bond.empty() && bond[p].bonded)
          assemble_bond(state, assembler, p);
        assemble_contact(state, assembler, p);
      }
    seconds += timer.wall_time();
    return true;
  }

  void NodeToSegment::count_change(const unsigned int point, const int state)
  {
    if (last_state[point] != state)
      ++state_changes;
    last_state[point] = state;
  }

  void NodeToSegment::assemble_bond(const Configuration &state,
                                    Assembler &          assembler,
                                    const unsigned int   p)
  {
    const unsigned int dim   = slave_surface.n_dimensions();
    const double       area  = points[p].area;
    const Point<3>     x     = x_points[p];
    const AnchorPlace  place = master.place(bond[p].anchor);

    const bool may_jump = state.iteration > freeze_after &&
                          state.iteration <= freeze_after + jump_iterations;
    std::optional<AdhesionStatus> forced;
    if (state.iteration > freeze_after && !may_jump &&
        bond_trial[p].status != AdhesionStatus::separated)
      forced = static_cast<AdhesionStatus>(
        std::min(last_state[p], static_cast<int>(AdhesionStatus::separated)));
    AdhesionResponse response = description.adhesion->evaluate(
      x - place.x, place.normal, bond[p].state, forced);
    if (!response.consistent) // freezing must not end in a wrong state
      response = description.adhesion->evaluate(x - place.x,
                                                place.normal,
                                                bond[p].state);
    if (response.status != AdhesionStatus::separated)
      count_change(p, static_cast<int>(response.status));
    if (may_jump && response.status == AdhesionStatus::decohesion)
      {
        const Tensor<1, 3> gap = x - place.x;
        response.dt_dg         = jump_stiffness * (response.traction * gap) /
                         gap.norm_square() * unit_symmetric_tensor<3>();
        response.dt_dn = Tensor<2, 3>();
      }

    BondHistory &trial = bond_trial[p];
    trial.state        = response.state;
    trial.status       = response.status;
    trial.force        = -area * response.traction;
    if (response.anchor_shift.norm_square() > 0.)
      trial.anchor = master.shifted(bond[p].anchor, response.anchor_shift);
    if (response.status == AdhesionStatus::separated &&
        trial.separation_time < 0.)
      trial.separation_time = state.time;
    now.stored += area * response.stored;
    now.lost += area * response.dissipated_increment;
    if (response.dissipated_increment > 0.)
      now.front += area;
    now.external += .5 * (bond[p].force + trial.force) *
                    master.displacement_since(state.time - state.dt, place.x);
    if (response.status == AdhesionStatus::separated)
      return;

    // q = (x_s, anchor nodes); dg = dx_s - sum N_I dx_I
    LocalUnknowns local;
    local.add(slave.nodes[points[p].node], 0, dim);
    for (unsigned int i = 0; i < place.n_nodes; ++i)
      local.add(master.nodes[place.nodes[i]], 1 + i, dim);
    std::array<double, 15>                 R{};
    std::array<std::array<double, 15>, 15> K{};
    for (unsigned int a = 0; a <= place.n_nodes; ++a)
      {
        const double w_a = a == 0 ? 1. : -place.N[a - 1];
        for (unsigned int i = 0; i < 3; ++i)
          R[3 * a + i] = w_a * response.traction[i];
        if (assembler.with_tangent())
          for (unsigned int b = 0; b <= place.n_nodes; ++b)
            {
              const double w_b = b == 0 ? 1. : -place.N[b - 1];
              Tensor<2, 3> dt  = w_b * response.dt_dg;
              if (b > 0)
                dt += response.dt_dn * place.dnormal[b - 1] -
                      response.dt_dg * place.doffset[b - 1];
              for (unsigned int i = 0; i < 3; ++i)
                for (unsigned int j = 0; j < 3; ++j)
                  K[3 * a + i][3 * b + j] = w_a * dt[i][j];
            }
      }
    scatter(assembler, local, area, R, K);
  }

  bool NodeToSegment::may_close(const Configuration &state,
                                const unsigned int   p,
                                const ContactPoint & found) const
  {
    const auto &surface = master.surface;
    if (found.gap > touching || !master.is_rigid())
      return true;
    if (contact[p].closed && surface.bound(contact[p].last_facet).normal *
                                 surface.bound(found.facet).normal >
                               smooth_cosine)
      return true;
    if (contact[p].closed && found.kind != ContactCase::face)
      {
        // Concave, as the point is behind it: an edge or corner of the facet
        // that held the point leaves no way through.
        const auto &held  = surface.facet(contact[p].last_facet).nodes;
        const auto &nodes = found.nodes;
        if (std::all_of(nodes.begin(),
                        nodes.begin() + found.n_nodes,
                        [&held](const unsigned int i) {
                          return std::count(held.begin(), held.end(), i) > 0;
                        }))
          return true;
      }
    const Point<3> x_old =
      master.carried(state.time - state.dt,
                     current(slave.nodes[points[p].node],
                             state.u_old,
                             slave_surface.n_dimensions()));
    const Tensor<1, 3> &n       = found.mean_normal;
    const double        old_gap = found.gap + n * (x_old - x_points[p]);
    return old_gap > -.01 * points[p].depth;
  }

  std::optional<ContactPoint> NodeToSegment::pair(const Configuration &state,
                                                  const unsigned int   p)
  {
    std::optional<ContactPoint> found;
    if (state.iteration > freeze_after && last_pairing[p])
      found = project_again(*last_pairing[p], x_points[p], master.surface);
    if (!found)
      found = find_contact(x_points[p],
                           slave_normal(points[p], slave_surface),
                           master.surface,
                           search.candidates(p),
                           contact[p].last_facet,
                           {description.search_distance, points[p].depth});
    if (found && !may_close(state, p, *found))
      return std::nullopt;
    return found;
  }

  void NodeToSegment::assemble_contact(const Configuration &state,
                                       Assembler &          assembler,
                                       const unsigned int   p)
  {
    const unsigned int dim    = slave_surface.n_dimensions();
    const double       area   = points[p].area;
    ContactHistory &   trial  = contact_trial[p];
    const bool         has_bond = !bond.empty() && bond_trial[p].bonded &&
                          bond_trial[p].status != AdhesionStatus::separated;

    const auto found = pair(state, p);
    last_pairing[p]  = found;
    trial.closed     = found && found->gap <= touching;
    trial.gap        = found ? found->gap : 1e300;
    trial.force      = Tensor<1, 3>();
    if (found)
      trial.last_facet = found->facet;

    const double c         = area * description.penalty;
    const double old_press = contact[p].closed ? contact[p].gap : 0.;
    const double new_press = trial.closed ? trial.gap : 0.;
    if (found && contact[p].gap < 1e299)
      now.impact += .5 * c *
                    ((old_press + new_press) * (trial.gap - contact[p].gap) -
                     (new_press * new_press - old_press * old_press));
    if (!trial.closed)
      {
        if (!friction.empty())
          friction_trial[p].active = false;
        if (!has_bond)
          count_change(p, state_free);
      }
    else
      {
        const ContactKinematics kinematics =
          contact_kinematics(*found, x_points[p], master.surface);
        LocalUnknowns local;
        local.add(slave.nodes[points[p].node], 0, dim);
        if (!master.is_rigid())
          for (unsigned int i = 0; i < kinematics.n_nodes; ++i)
            local.add(master.nodes[kinematics.nodes[i]], 1 + i, dim);
        std::array<double, 15>                 R;
        std::array<std::array<double, 15>, 15> K;
        normal_contact_force(kinematics, description.penalty, R, K);
        scatter(assembler, local, area, R, K);
        trial.force = -c * kinematics.gap * kinematics.normal;
        now.stored += .5 * c * kinematics.gap * kinematics.gap;
        if (!has_bond)
          count_change(p, state_contact);
        if (!friction.empty())
          assemble_friction(state, assembler, p, kinematics, trial.force);
      }
    if (master.is_rigid() && (contact[p].closed || trial.closed))
      now.external +=
        .5 * (contact[p].force + trial.force) *
        master.displacement_since(state.time - state.dt, x_points[p]);
  }

  void NodeToSegment::assemble_friction(const Configuration &,
                                        Assembler &              assembler,
                                        const unsigned int       p,
                                        const ContactKinematics &kinematics,
                                        Tensor<1, 3> &           force)
  {
    const unsigned int dim  = slave_surface.n_dimensions();
    const double       area = points[p].area;
    if (!friction[p].active) // closes in this increment: no stick memory yet
      {
        friction_trial[p].active = true;
        friction_trial[p].stick =
          master.drag_anchor(last_pairing[p]->facet, kinematics.x_m);
        return;
      }
    double weight = description.friction;
    if (!bond.empty() && bond[p].bonded)
      weight *= description.adhesion->friction_weight(bond[p].state.kappa);

    const AnchorPlace place = master.place(friction[p].stick);
    FrictionAnchor    anchor;
    anchor.n_nodes = place.n_nodes;
    anchor.nodes   = place.nodes;
    anchor.N       = place.N;
    anchor.x       = place.x;
    const FrictionPenalties penalties = {description.penalty,
                                         description.friction_penalty,
                                         weight};
    const FrictionForce     result =
      friction_force(kinematics, anchor, penalties);

    LocalUnknowns local;
    local.add(slave.nodes[points[p].node], 0, dim);
    if (!master.is_rigid())
      {
        for (unsigned int i = 0; i < kinematics.n_nodes; ++i)
          local.add(master.nodes[kinematics.nodes[i]], 1 + i, dim);
        for (unsigned int i = 0; i < anchor.n_nodes; ++i)
          local.add(master.nodes[anchor.nodes[i]],
                    1 + kinematics.n_nodes + i,
                    dim);
      }
    scatter(assembler, local, area, result.R, result.K);
    force -= area * result.traction;
    now.stored += area * result.stored;
    now.friction += area * result.dissipation;
    if (result.state == FrictionState::slip)
      {
        count_change(p, state_slip);
        const Point<3> x =
          new_anchor(kinematics, anchor, result, penalties);
        friction_trial[p].stick =
          master.drag_anchor(last_pairing[p]->facet, x);
      }
  }

  unsigned int NodeToSegment::n_state_changes() const
  {
    return state_changes;
  }

  IncrementError NodeToSegment::increment_error() const
  {
    if (!description.adhesion)
      return {};
    const double lost  = Utilities::MPI::sum(now.lost, communicator);
    const double front = Utilities::MPI::sum(now.front, communicator);
    if (front <= 0.)
      return {};
    return {lost / (tolerated_decohesion *
                    description.adhesion->fracture_energy() * front),
            1.};
  }

  std::vector<ClosedPoint> NodeToSegment::closed_points() const
  {
    std::vector<ClosedPoint> list;
    if (!master.is_rigid())
      return list;
    const unsigned int dim = slave_surface.n_dimensions();
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        if (!just_closed[p])
          continue;
        const Tensor<1, 3> n =
          contact_kinematics(*last_pairing[p], x_points[p], master.surface)
            .normal;
        const Tensor<1, 3> v = master.velocity(x_points[p], 1e-3 * last_dt);
        const auto &       unknowns = slave.nodes[points[p].node].unknowns;
        list.push_back({{unknowns.begin(), unknowns.begin() + dim},
                        {{n[0], n[1], n[2]}},
                        {{v[0], v[1], v[2]}}});
      }
    return list;
  }

  Energies NodeToSegment::energies() const
  {
    Energies e;
    e.stored = now.stored;
    for (unsigned int p = 0; p < bond_trial.size(); ++p)
      e.adhesion += points[p].area * bond_trial[p].state.dissipated;
    e.friction = committed_friction + now.friction;
    e.impact   = committed_impact + now.impact;
    e.external = committed_external + now.external;
    return e;
  }

  void NodeToSegment::commit()
  {
    for (unsigned int p = 0; p < points.size(); ++p)
      just_closed[p] = contact_trial[p].closed && !contact[p].closed;
    contact  = contact_trial;
    friction = friction_trial;
    bond     = bond_trial;
    if (description.adhesion && description.adhesion->rest_efficiency > 0.)
      bond_again();
    committed_friction += now.friction;
    committed_impact += now.impact;
    committed_external += now.external;
    committed_stored = now.stored;
    now              = Increment();
    now.stored       = committed_stored;
  }

  void NodeToSegment::bond_again()
  {
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        if (!bond[p].bonded || bond[p].status != AdhesionStatus::separated)
          continue;
        bond[p].state = description.adhesion->rested(
          bond[p].state,
          contact[p].closed ? -description.penalty * contact[p].gap : 0.,
          last_dt);
        if (bond[p].state.kappa > 0. || !last_pairing[p])
          continue;
        bond[p].anchor          = master.set_anchor(last_pairing[p]->facet,
                                           last_pairing[p]->xi,
                                           x_points[p]);
        bond[p].status          = AdhesionStatus::adhering;
        bond[p].separation_time = -1.;
        bond[p].force           = Tensor<1, 3>();
      }
    bond_trial = bond;
  }

  void NodeToSegment::revert()
  {
    contact_trial  = contact;
    friction_trial = friction;
    bond_trial     = bond;
    now            = Increment();
    now.stored     = committed_stored;
  }

  std::size_t NodeToSegment::history_bytes() const
  {
    return 2 * (contact.size() * sizeof(ContactHistory) +
                friction.size() * sizeof(FrictionHistory) +
                bond.size() * sizeof(BondHistory));
  }

  void NodeToSegment::save(std::ostream &out) const
  {
    HistoryWriter writer;
    auto          copies = *this; // serialize() wants mutable references
    for (auto &h : copies.contact)
      h.serialize(writer);
    for (auto &h : copies.friction)
      h.serialize(writer);
    for (auto &h : copies.bond)
      h.serialize(writer);
    for (const double x : {committed_friction,
                           committed_impact,
                           committed_external,
                           committed_stored})
      writer.values.push_back(x);
    write_values(out, writer.values);
  }

  void NodeToSegment::load(std::istream &in)
  {
    const std::vector<double> values = read_values(in);
    HistoryReader             reader{values};
    for (auto &h : contact)
      h.serialize(reader);
    for (auto &h : friction)
      h.serialize(reader);
    for (auto &h : bond)
      h.serialize(reader);
    reader &committed_friction &committed_impact &committed_external
      &committed_stored;
    revert();
  }

  std::vector<PointReport> NodeToSegment::report() const
  {
    std::vector<PointReport> list;
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        const bool   closed = contact_trial[p].closed;
        PointReport  report;
        report.node     = slave.nodes[points[p].node];
        report.area     = points[p].area;
        report.gap      = contact_trial[p].gap;
        report.pressure = closed ? -description.penalty * contact_trial[p].gap :
                                   0.;
        report.force    = contact_trial[p].force;
        report.state    = last_state[p];
        report.bonded   = false;
        report.damage   = 1.;
        report.separation_time = -1.;
        if (!bond_trial.empty() && bond_trial[p].bonded)
          {
            const BondHistory &b = bond_trial[p];
            report.force += b.force;
            report.bonded = b.status != AdhesionStatus::separated;
            report.damage =
              std::min(1.,
                       b.state.kappa / description.adhesion->rupture_gap());
            report.separation_time = b.separation_time;
          }
        list.push_back(report);
      }
    return list;
  }

  InterfaceSums NodeToSegment::sums() const
  {
    InterfaceSums sums;
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        const double area = points[p].area;
        sums.force += contact_trial[p].force;
        sums.area += area;
        if (contact_trial[p].closed)
          sums.closed += area;
        if (!bond_trial.empty() && bond_trial[p].bonded)
          {
            sums.force += bond_trial[p].force;
            if (bond_trial[p].status != AdhesionStatus::separated)
              sums.bonded += area;
          }
      }
    sums.points = Utilities::MPI::sum(
      static_cast<unsigned int>(points.size()), communicator);
    for (double *x : {&sums.area, &sums.bonded, &sums.closed})
      *x = Utilities::MPI::sum(*x, communicator);
    sums.force = Utilities::MPI::sum(sums.force, communicator);
    return sums;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces of one slave point of the node-to-segment term: bond, pressure,
// friction.
#include "contact/bond_force.h"
#include "contact/node_to_segment.h"

namespace demold
{
  using namespace dealii;

  void NodeToSegment::count_change(const unsigned int point, const int state)
  {
    if (last_state[point] != state)
      ++state_changes;
    last_state[point] = state;
  }

  AdhesionResponse NodeToSegment::respond(const Configuration &state,
                                          const unsigned int   p,
                                          const AnchorPlace   &place)
  {
    const BondHistory &old = committed.bond[p];
    const Tensor<1, 3> gap = surfaces.x(p) - place.x;
    if (state.iteration == 0 && !driven.empty() && driven[p])
      return law->evaluate(gap,
                           place.normal,
                           old.state,
                           AdhesionStatus::decohesion);
    return bond_response(*law,
                         gap,
                         place.normal,
                         old,
                         last_bond_status[p],
                         {state.iteration});
  }

  void NodeToSegment::assemble_bond(const Configuration &state,
                                    Assembler           &assembler,
                                    const unsigned int   p)
  {
    const BondHistory     &old      = committed.bond[p];
    const Master          &master   = surfaces.master();
    const double           area     = surfaces.point(p).area;
    const AnchorPlace      place    = master.place(old.anchor);
    const AdhesionResponse response = respond(state, p, place);
    last_bond_status[p]             = response.status;

    BondHistory &bond = trial.bond[p];
    bond.state        = response.state;
    bond.status       = response.status;
    bond.force        = -area * response.traction;
    if (response.anchor_shift.norm_square() > 0.)
      bond.anchor = master.shifted(old.anchor, response.anchor_shift);
    if (response.status == AdhesionStatus::separated &&
        bond.separation_time < 0.)
      bond.separation_time = state.time;
    now.stored += area * response.stored;
    now.regularisation += area * response.regularisation_increment;
    increment.lost += area * response.dissipated_increment;
    if (response.dissipated_increment > 0.)
      increment.front += area;
    now.external += .5 * (old.force + bond.force) *
                    master.displacement_since(state.time - state.dt, place.x);
    if (response.status == AdhesionStatus::separated)
      return;

    const BondForce force =
      bond_force(response, place, assembler.with_tangent());
    NodalUnknowns unknowns = surfaces.unknowns(p);
    surfaces.add_master_unknowns(place.nodes, place.n_nodes, 1, unknowns);
    add_forces(assembler, unknowns, area, force.R, force.K);
  }

  int NodeToSegment::assemble_contact(const Configuration &state,
                                      Assembler           &assembler,
                                      const unsigned int   p)
  {
    const ContactHistory &old     = committed.contact[p];
    ContactHistory       &contact = trial.contact[p];
    const auto           &found   = surfaces.pair(state, p, old);

    contact.closed = found && found->gap <= touching_gap;
    contact.gap    = found ? found->gap : 1e300;
    contact.force  = Tensor<1, 3>();
    if (found)
      contact.last_facet = found->facet;

    const double c         = surfaces.point(p).area * description.penalty;
    const double old_press = old.closed ? old.gap : 0.;
    const double new_press = contact.closed ? contact.gap : 0.;
    if (found && old.gap < 1e299)
      now.impact += .5 * c *
                    ((old_press + new_press) * (contact.gap - old.gap) -
                     (new_press * new_press - old_press * old_press));
    bool slips = false;
    if (contact.closed)
      {
        const ContactKinematics kinematics =
          contact_kinematics(*found, surfaces.x(p), surfaces.master().surface);
        assemble_pressure(assembler, p, kinematics);
        if (!trial.friction.empty())
          slips = assemble_friction(state, assembler, p, kinematics);
      }
    else if (!trial.friction.empty())
      let_go_of_friction(p);
    if (surfaces.master().is_rigid() && (old.closed || contact.closed))
      now.external +=
        .5 * (old.force + contact.force) *
        surfaces.master().displacement_since(state.time - state.dt,
                                             surfaces.x(p));
    return slips ? state_slip : contact.closed ? state_contact : state_free;
  }

  void NodeToSegment::assemble_pressure(Assembler               &assembler,
                                        const unsigned int       p,
                                        const ContactKinematics &kinematics)
  {
    const double  area     = surfaces.point(p).area;
    const double  c        = area * description.penalty;
    NodalUnknowns unknowns = surfaces.unknowns(p);
    surfaces.add_master_unknowns(kinematics.nodes,
                                 kinematics.n_nodes,
                                 1,
                                 unknowns);
    std::array<double, 15>                 R;
    std::array<std::array<double, 15>, 15> K;
    normal_contact_force(kinematics, description.penalty, R, K);
    add_forces(assembler, unknowns, area, R, K);
    trial.contact[p].force = -c * kinematics.gap * kinematics.normal;
    now.stored += .5 * c * kinematics.gap * kinematics.gap;
  }

  void NodeToSegment::let_go_of_friction(const unsigned int p)
  {
    const FrictionHistory &old = committed.friction[p];
    if (old.active)
      now.friction +=
        surfaces.point(p).area *
        loss_of_opening(old.traction,
                        surfaces.x(p) - surfaces.master().place(old.stick).x);
    trial.friction[p] = FrictionHistory();
  }

  bool NodeToSegment::assemble_friction(const Configuration     &state,
                                        Assembler               &assembler,
                                        const unsigned int       p,
                                        const ContactKinematics &kinematics)
  {
    const FrictionHistory &old      = committed.friction[p];
    FrictionHistory       &friction = trial.friction[p];
    const Master          &master   = surfaces.master();
    const unsigned int     facet    = surfaces.last_pairing(p)->facet;
    if (!old.active) // closes in this increment: no stick memory yet
      {
        friction.active = true;
        friction.stick  = master.drag_anchor(facet, kinematics.x_m);
        return false;
      }
    double weight = description.friction;
    if (!committed.bond.empty() && committed.bond[p].bonded)
      weight *=
        description.adhesion->friction_weight(committed.bond[p].state.kappa);

    // Extrapolated displacements under pressures that do not belong to them
    // would set a whole surface sliding, and Newton would not find back.
    if (state.extrapolated && !old.slips())
      weight = 1e9;

    const AnchorPlace place = master.place(old.stick);
    FrictionAnchor    anchor;
    anchor.n_nodes                    = place.n_nodes;
    anchor.nodes                      = place.nodes;
    anchor.N                          = place.N;
    anchor.x                          = place.x;
    anchor.traction                   = old.traction;
    anchor.limit                      = old.limit;
    const FrictionPenalties penalties = {description.penalty,
                                         description.friction_penalty,
                                         weight};
    const FrictionForce result = friction_force(kinematics, anchor, penalties);

    NodalUnknowns      unknowns = surfaces.unknowns(p);
    const unsigned int n        = kinematics.n_nodes;
    surfaces.add_master_unknowns(kinematics.nodes, n, 1, unknowns);
    surfaces.add_master_unknowns(anchor.nodes, anchor.n_nodes, 1 + n, unknowns);
    const double area = surfaces.point(p).area;
    add_forces(assembler, unknowns, area, result.R, result.K);
    trial.contact[p].force -= area * result.traction;
    now.stored += area * result.stored;
    now.friction += area * result.dissipation;
    friction.traction = result.traction;
    friction.limit    = result.limit;
    if (result.state != FrictionState::stick)
      friction.stick =
        master.drag_anchor(facet,
                           new_anchor(kinematics, anchor, result, penalties));
    return result.state == FrictionState::slip;
  }
} // namespace demold

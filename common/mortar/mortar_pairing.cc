// SPDX-License-Identifier: LGPL-2.1-or-later
// Which points of the mortar term have something before them, and which bond.
#include "contact/closest_point.h"
#include "contact/current_positions.h"
#include "mortar/mortar_term.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// A point covered by less than this share of its area has no multiplier
    /// (theory B.11).
    constexpr double smallest_cover = .01;
  } // namespace

  void MortarTerm::start_points()
  {
    rows =
      mortar.rows(std::vector<RowDemand>(committed.size(), RowDemand::values));
    normals = mortar.normals();
    for (unsigned int own = 0; own < committed.size(); ++own)
      {
        const NodalRow &row = rows[own];
        if (!is_covered(own))
          continue;
        MultiplierHistory &history = committed[own];
        history.has_gap            = true;
        history.area               = row.area;
        history.gap_N = normals[own].n * weighted_gap(surfaces, row) / row.area;
        history.closed        = history.gap_N <= touching_gap || touches(own);
        history.law.may_stick = history.closed;
        const Point<3> &X     = surfaces.x(point(own).node);
        if (description.adhesion && description.bonded(X) &&
            std::abs(history.gap_N) <= .5 * description.adhesion->rupture_gap())
          bond(own);
      }
    keep_slip_rows();
  }

  /// Does the node of the point lie on the other surface?
  bool MortarTerm::touches(const unsigned int own) const
  {
    const Point<3> &x = surfaces.x(point(own).node);
    for (const unsigned int face : point(own).facets)
      for (const unsigned int facet : surfaces.opposite(face))
        {
          const Projection foot =
            project(x, surfaces.master().surface.facet_positions(facet));
          if (foot.found && (x - foot.x).norm() <= touching_gap &&
              std::abs(foot.xi[0]) <= 1. + inside_tolerance &&
              std::abs(foot.xi[1]) <= 1. + inside_tolerance)
            return true;
        }
    return false;
  }

  bool MortarTerm::is_covered(const unsigned int own) const
  {
    return rows[own].area > smallest_cover * point(own).area;
  }

  bool MortarTerm::holds_at_start(const Configuration &state,
                                  const unsigned int   own) const
  {
    return state.iteration == 0 && committed[own].closed &&
           committed[own].traction.norm_square() == 0.;
  }

  /// Surfaces that touch at the start hold each other in the first iteration.
  /// Later a closed point stays closed as long as its multiplier presses, an
  /// open one closes when its gap does, whatever c_N is (primal-dual active
  /// set).
  std::optional<bool> MortarTerm::is_pressed(const Configuration &state,
                                             const unsigned int   own) const
  {
    if (holds_at_start(state, own))
      return true;
    if (resolvent.holds(committed[own].law) ||
        newton_memory[own].contact == ContactStatus::open)
      return {};
    return normals[own].n * multiplier(state, own) < 0.;
  }

  /// Does the point have a part of the other surface before it, and is that
  /// believed? A point closes by coming through the gap: a rigid surface that
  /// it already was behind at t_n, without touching it, is not (as in
  /// SurfacePair).
  bool MortarTerm::is_opposed(const Configuration &state,
                              const unsigned int   own) const
  {
    if (!is_covered(own))
      return false;
    if (committed[own].closed || !surfaces.master().is_rigid())
      return true;
    const Tensor<1, 3> &n = normals[own].n;
    const double gap = n * weighted_gap(surfaces, rows[own]) / rows[own].area;
    if (gap > 0.)
      return true;
    const unsigned int node  = point(own).node;
    const Point<3>     x_old = surfaces.master().carried(
      state.time - state.dt,
      current_position(surfaces.node(node), state.u_old, surfaces.dim()));
    return gap + n * (surfaces.x(node) - x_old) > -.01 * point(own).depth;
  }

  void MortarTerm::bond(const unsigned int own)
  {
    NodalRow           row   = rows[own].values();
    const Tensor<1, 3> gap   = weighted_gap(surfaces, row) / row.area;
    const unsigned int facet = nearest_facet(own);
    if (surfaces.master().is_rigid())
      {
        row = slave_side(surfaces, row);
        frozen[own].anchor =
          surfaces.master().set_anchor(facet,
                                       {{0., 0.}},
                                       slave_point(surfaces, row));
      }
    else
      frozen[own].anchor = surfaces.master().set_anchor(
        facet,
        {{0., 0.}},
        surfaces.master().surface.bound(facet).centre + gap);
    frozen[own].row              = row;
    committed[own].law           = resolvent.fresh_bond();
    committed[own].law.may_stick = committed[own].closed;
    committed[own].gap           = Tensor<1, 3>();
    committed[own].number        = static_cast<int>(AdhesionStatus::adhering);
  }

  unsigned int MortarTerm::nearest_facet(const unsigned int own) const
  {
    const Point<3> &x       = surfaces.x(point(own).node);
    unsigned int    nearest = numbers::invalid_unsigned_int;
    double          least   = 1e300;
    for (const unsigned int face : point(own).facets)
      for (const unsigned int facet : surfaces.opposite(face))
        {
          const double distance =
            (surfaces.master().surface.bound(facet).centre - x).norm();
          if (distance < least)
            {
              least   = distance;
              nearest = facet;
            }
        }
    return nearest;
  }

  /// Slip counts from the operator of t_n. A point whose bond has just gone
  /// has none yet: the frozen one served it.
  void MortarTerm::keep_slip_rows()
  {
    if (description.friction <= 0.)
      return;
    std::vector<RowDemand> demand(committed.size(), RowDemand::nothing);
    const auto             slides = [&](const unsigned int own) {
      return committed[own].closed && !resolvent.holds(committed[own].law);
    };
    for (unsigned int own = 0; own < committed.size(); ++own)
      if (slides(own) && rows[own].nodes.empty())
        demand[own] = RowDemand::values;
    const std::vector<NodalRow> missing = mortar.rows(demand);
    for (unsigned int own = 0; own < committed.size(); ++own)
      if (demand[own] == RowDemand::values)
        slip_rows[own] = missing[own];
      else
        slip_rows[own] = slides(own) ? rows[own].values() : NodalRow();
  }

  void MortarTerm::bond_again()
  {
    for (unsigned int own = 0; own < committed.size(); ++own)
      {
        MultiplierHistory &history = committed[own];
        if (!history.law.bonded || resolvent.holds(history.law))
          continue;
        const double pressure =
          history.closed ? -history.traction * normals[own].n : 0.;
        const ResolventState rested =
          resolvent.rested(history.law, pressure, last_dt);
        history.law = rested;
        if (!resolvent.holds(rested))
          continue;
        bond(own);
        history.law.bond        = rested.bond;
        history.separation_time = -1.;
        slip_rows[own]          = NodalRow();
      }
  }
} // namespace demold

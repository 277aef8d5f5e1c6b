// SPDX-License-Identifier: LGPL-2.1-or-later
// What the mortar term tells others: energies, points, sums, errors, history.
#include "contact/point_history.h"
#include "mortar/mortar_term.h"
#include "weak_form/vector_io.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  void MortarTerm::count_change(const unsigned int own, const int number)
  {
    if (last_number[own] != number)
      ++state_changes;
    last_number[own] = number;
  }

  void MortarTerm::account(const Configuration      &state,
                           const unsigned int        own,
                           const ConstraintInput    &input,
                           const ConstraintResponse &response,
                           const PointGap           &gap)
  {
    const MultiplierHistory &old   = committed[own];
    MultiplierHistory       &point = trial[own];
    const ResolventResponse &law   = response.law;
    settled                        = settled && law.consistent;
    newton_memory[own]             = newton_memory[own].after(law);

    point.law      = law.state;
    point.number   = law.number();
    point.closed   = law.contact != ContactStatus::open;
    point.has_gap  = true;
    point.gap      = gap.gap;
    point.gap_N    = gap.gap * input.normal;
    point.traction = input.traction;
    point.sprung   = input.sprung;
    point.area     = gap.area;
    if (old.law.bonded && !resolvent.holds(law.state) &&
        point.separation_time < 0.)
      point.separation_time = state.time;
    count_change(own, point.number);

    now.stored += gap.area * law.stored;
    for (unsigned int d = 0; d < 3; ++d)
      now.stored +=
        .5 * gap.area * compliance[own][d] * std::pow(input.sprung[d], 2);
    now.friction += gap.area * law.friction_increment;
    increment.lost += gap.area * law.dissipated_increment;
    if (law.dissipated_increment > 0.)
      increment.front += gap.area;
    const NodalRow &row = row_of(own);
    // Pressure that works while the point closes or opens; what its compliance
    // takes is stored.
    const auto unstored = [&](const MultiplierHistory &history) {
      double gap_N = history.gap_N;
      for (unsigned int d = 0; d < 3; ++d)
        gap_N -= input.normal[d] * compliance[own][d] * history.sprung[d];
      return gap_N;
    };
    if (old.has_gap)
      now.impact += .5 * gap.area *
                    (std::min(0., old.traction * input.normal) +
                     std::min(0., input.traction * input.normal)) *
                    (unstored(point) - unstored(old));
    if (surfaces.master().is_rigid())
      now.external +=
        .5 * (old.force() + point.force()) *
        surfaces.master().displacement_since(state.time - state.dt,
                                             slave_point(surfaces, row) +
                                               gap.gap);
  }

  unsigned int MortarTerm::n_state_changes() const
  {
    return state_changes;
  }

  bool MortarTerm::has_settled() const
  {
    return settled;
  }

  IncrementError MortarTerm::increment_error() const
  {
    if (!description.adhesion)
      return {};
    return decohesion_error(*description.adhesion,
                            increment.lost,
                            increment.front,
                            communicator);
  }

  std::vector<ClosedPoint> MortarTerm::closed_points() const
  {
    std::vector<ClosedPoint> list;
    if (!surfaces.master().is_rigid())
      return list;
    for (unsigned int own = 0; own < committed.size(); ++own)
      {
        if (!just_closed[own])
          continue;
        const unsigned int node = point(own).node;
        const Tensor<1, 3> n    = normals[own].n;
        const Tensor<1, 3> v =
          surfaces.master().velocity(surfaces.x(node), 1e-3 * last_dt);
        const auto &unknowns = surfaces.node(node).unknowns;
        list.push_back({{unknowns.begin(), unknowns.begin() + surfaces.dim()},
                        {{n[0], n[1], n[2]}},
                        {{v[0], v[1], v[2]}}});
      }
    return list;
  }

  Energies MortarTerm::energies() const
  {
    Energies e;
    e.stored = now.stored;
    for (unsigned int own = 0; own < trial.size(); ++own)
      if (trial[own].law.bonded)
        e.adhesion += frozen[own].row.area * trial[own].law.bond.dissipated;
    e.friction = committed_work.friction + now.friction;
    e.impact   = committed_work.impact + now.impact;
    e.external = committed_work.external + now.external;
    return e;
  }

  std::vector<PointReport> MortarTerm::report() const
  {
    std::vector<PointReport> list;
    for (unsigned int own = 0; own < trial.size(); ++own)
      {
        const MultiplierHistory &history = trial[own];
        PointReport              report;
        report.node     = surfaces.node(point(own).node);
        report.area     = point(own).area;
        report.gap      = history.has_gap ? history.gap_N : 1e300;
        report.pressure = std::max(0., -(history.traction * normals[own].n));
        report.force    = history.force();
        report.bonded   = resolvent.holds(history.law);
        report.damage   = history.law.bonded ?
                            std::min(1.,
                                   history.law.bond.kappa /
                                     resolvent.adhesion->rupture_gap()) :
                            1.;
        report.state    = history.number;
        report.separation_time = history.separation_time;
        list.push_back(report);
      }
    return list;
  }

  InterfaceSums MortarTerm::sums() const
  {
    InterfaceSums sums;
    for (unsigned int own = 0; own < trial.size(); ++own)
      {
        sums.force += trial[own].force();
        sums.area += point(own).area;
        if (trial[own].closed)
          sums.closed += trial[own].area;
        if (resolvent.holds(trial[own].law))
          sums.bonded += frozen[own].row.area;
      }
    sums.points = Utilities::MPI::sum(static_cast<unsigned int>(trial.size()),
                                      communicator);
    for (double *x : {&sums.area, &sums.bonded, &sums.closed})
      *x = Utilities::MPI::sum(*x, communicator);
    sums.force = Utilities::MPI::sum(sums.force, communicator);
    return sums;
  }

  std::size_t MortarTerm::history_bytes() const
  {
    std::size_t bytes =
      (committed.size() + trial.size()) * sizeof(MultiplierHistory);
    for (const FrozenRow &f : frozen)
      bytes += f.row.nodes.empty() ? 0 : sizeof(FrozenRow) + f.row.bytes();
    for (const NodalRow &row : slip_rows)
      bytes += row.bytes();
    return bytes;
  }

  void MortarTerm::save(std::ostream &out) const
  {
    HistoryWriter writer;
    for (unsigned int own = 0; own < committed.size(); ++own)
      {
        MultiplierHistory history = committed[own]; // serialize() may write
        FrozenRow         bond    = frozen[own];
        NodalRow          slip    = slip_rows[own];
        history.serialize(writer);
        writer &bond.anchor;
        bond.row.serialize(writer);
        slip.serialize(writer);
      }
    Energies work    = committed_work;
    double   largest = largest_accepted;
    writer &work.friction &work.impact &work.external &work.stored &largest;
    write_values(out, writer.values);
  }

  void MortarTerm::load(std::istream &in)
  {
    const std::vector<double> values = read_values(in);
    HistoryReader             reader{values};
    for (unsigned int own = 0; own < committed.size(); ++own)
      {
        committed[own].serialize(reader);
        reader &frozen[own].anchor;
        frozen[own].row.serialize(reader);
        slip_rows[own].serialize(reader);
      }
    reader &committed_work.friction &committed_work.impact &committed_work
      .external &committed_work.stored &largest_accepted;
    revert();
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// What the node-to-segment term tells others: points, sums, energies, errors.
#include "contact/node_to_segment.h"

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace demold
{
  using namespace dealii;

  unsigned int NodeToSegment::n_state_changes() const
  {
    return state_changes;
  }

  IncrementError NodeToSegment::increment_error() const
  {
    if (!description.adhesion)
      return {};
    return decohesion_error(*description.adhesion,
                            increment.lost,
                            increment.front,
                            communicator);
  }

  std::vector<ClosedPoint> NodeToSegment::closed_points() const
  {
    std::vector<ClosedPoint> list;
    const Master            &master = surfaces.master();
    if (!master.is_rigid())
      return list;
    for (unsigned int p = 0; p < surfaces.n_points(); ++p)
      {
        if (!just_closed[p])
          continue;
        const Point<3>    &x = surfaces.x(p);
        const Tensor<1, 3> n =
          contact_kinematics(*surfaces.last_pairing(p), x, master.surface)
            .normal;
        const Tensor<1, 3> v        = master.velocity(x, 1e-3 * last_dt);
        const auto        &unknowns = surfaces.node(p).unknowns;
        list.push_back({{unknowns.begin(), unknowns.begin() + surfaces.dim()},
                        {{n[0], n[1], n[2]}},
                        {{v[0], v[1], v[2]}}});
      }
    return list;
  }

  Energies NodeToSegment::energies() const
  {
    Energies e;
    e.stored = now.stored;
    for (unsigned int p = 0; p < trial.bond.size(); ++p)
      e.adhesion += surfaces.point(p).area * trial.bond[p].state.dissipated;
    e.friction       = committed_work.friction + now.friction;
    e.impact         = committed_work.impact + now.impact;
    e.external       = committed_work.external + now.external;
    e.regularisation = committed_work.regularisation + now.regularisation;
    return e;
  }

  std::vector<PointReport> NodeToSegment::report() const
  {
    std::vector<PointReport> list;
    for (unsigned int p = 0; p < surfaces.n_points(); ++p)
      {
        const ContactHistory &contact = trial.contact[p];
        PointReport           report;
        report.node = surfaces.node(p);
        report.area = surfaces.point(p).area;
        report.gap  = contact.gap;
        report.pressure =
          contact.closed ? -description.penalty * contact.gap : 0.;
        report.force           = contact.force;
        report.state           = last_state[p];
        report.bonded          = trial.holds(p);
        report.damage          = 1.;
        report.separation_time = -1.;
        if (!trial.bond.empty() && trial.bond[p].bonded)
          {
            const BondHistory &bond = trial.bond[p];
            report.force += bond.force;
            report.damage =
              std::min(1.,
                       bond.state.kappa / description.adhesion->rupture_gap());
            report.separation_time = bond.separation_time;
          }
        list.push_back(report);
      }
    return list;
  }

  InterfaceSums NodeToSegment::sums() const
  {
    InterfaceSums sums;
    for (unsigned int p = 0; p < surfaces.n_points(); ++p)
      {
        const double area = surfaces.point(p).area;
        sums.force += trial.contact[p].force;
        sums.area += area;
        if (trial.contact[p].closed)
          sums.closed += area;
        if (trial.holds(p))
          sums.bonded += area;
        if (!trial.bond.empty() && trial.bond[p].bonded)
          sums.force += trial.bond[p].force;
      }
    sums.points = Utilities::MPI::sum(surfaces.n_points(), communicator);
    for (double *x : {&sums.area, &sums.bonded, &sums.closed})
      *x = Utilities::MPI::sum(*x, communicator);
    sums.force = Utilities::MPI::sum(sums.force, communicator);
    return sums;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// A rubber law driven through a programme: the curve and its energies.
#include "rig/rig_curve.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  namespace
  {
    /// Pieces of a jump, each with two points of Gauss.
    constexpr unsigned int n_pieces = 32;

    /// Goes from the state of @p row to @p strain with rigid dashpots and adds
    /// the energies.
    void jump(RigPoint &point, const double strain, RigRow &row)
    {
      const double start = row.state.strain;
      const double piece = (strain - start) / n_pieces;
      for (unsigned int i = 0; i < n_pieces; ++i)
        {
          const double middle = start + (i + .5) * piece;
          for (const double side : {-1., 1.})
            row.work +=
              .5 * piece *
              point.strain_step(middle + side * .5 * piece / std::sqrt(3.), 0.)
                .force;
          row.dissipated +=
            point.strain_step(start + (i + 1) * piece, 0.).dissipated;
          point.commit();
        }
    }
  } // namespace



  RigCurve run_rig(const RubberLaw &law,
                   const RigMode    mode,
                   const Loading   &loading)
  {
    RigPoint point(law, mode);
    point.rest(loading.rest_strain);

    RigCurve curve;
    RigRow   row;
    row.state = point.state();
    curve.rows.push_back(row);
    if (loading.jumps())
      {
        jump(point,
             loading.stress_prescribed ?
               point.stress_step(loading.value(0.), 0.).strain :
               loading.value(0.),
             row);
        row.state = point.state();
        curve.rows.push_back(row);
      }

    for (const double time : loading.times())
      {
        const double    dt    = time - row.time;
        const double    value = loading.value(time);
        const RigState &next  = loading.stress_prescribed ?
                                  point.stress_step(value, dt) :
                                  point.strain_step(value, dt);
        row.work += .5 * (row.state.force + next.force) *
                    (next.strain - row.state.strain);
        row.dissipated += next.dissipated;
        row.time  = time;
        row.state = next;
        point.commit();
        curve.rows.push_back(row);
      }
    return curve;
  }



  double RigCurve::largest_nominal() const
  {
    double largest = rows.front().state.nominal;
    for (const auto &row : rows)
      largest = std::max(largest, row.state.nominal);
    return largest;
  }

  double RigCurve::smallest_nominal() const
  {
    double smallest = rows.front().state.nominal;
    for (const auto &row : rows)
      smallest = std::min(smallest, row.state.nominal);
    return smallest;
  }

  unsigned int RigCurve::n_iterations() const
  {
    unsigned int n = 0;
    for (const auto &row : rows)
      n += row.state.n_iterations;
    return n;
  }

  double RigCurve::work_between(const double start, const double end) const
  {
    const auto work_at = [&](const double time) {
      const RigRow *nearest = &rows.front();
      for (const auto &row : rows)
        if (std::abs(row.time - time) <= std::abs(nearest->time - time))
          nearest = &row;
      return nearest->work;
    };
    return work_at(end) - work_at(start);
  }

  double RigCurve::energy_balance_error() const
  {
    double       gap = 0., largest = 0.;
    const double at_rest = rows.front().state.stored;
    for (const auto &row : rows)
      {
        const double stored = row.state.stored - at_rest;
        gap     = std::max(gap, std::abs(row.work - stored - row.dissipated));
        largest = std::max({largest,
                            std::abs(row.work),
                            std::abs(stored),
                            std::abs(row.dissipated)});
      }
    return largest > 0. ? gap / largest : 0.;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Multipliers that their constraints alone leave undetermined: at supports and
// where patches meet (theory B.11).
#include "mortar/mortar_term.h"

#include <algorithm>
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
    /// Dual multipliers of one node share its displacement between them: with
    /// less, Newton sees a bond that is all but rigid up to its limit.
    constexpr double shared_compliance = .1;
  } // namespace

  void MortarTerm::find_compliance(
    const std::function<bool(types::global_dof_index)> &is_held)
  {
    const std::size_t n = committed.size();
    compliance.resize(n);
    leaning.resize(n);
    free.resize(n);
    driven.assign(n, false);
    shared.assign(n, false);
    std::vector<unsigned int> points_at_node(surfaces.n_slave_nodes(), 0);
    for (const SlavePoint &point : surfaces.points())
      ++points_at_node[point.node];
    for (unsigned int own = 0; own < n; ++own)
      {
        shared[own] = points_at_node[point(own).node] > 1;
        for (unsigned int d = 0; d < surfaces.dim(); ++d)
          find_compliance(is_held, own, d);
        if (is_condensed() && !has_own_rows(own))
          for (unsigned int d = 0; d < surfaces.dim(); ++d)
            compliance[own][d] =
              std::max(compliance[own][d], vanishing_compliance);
        compliance[own] /= stiffness;
      }
  }

  /// In direction @p d, over 1/c_N.
  void MortarTerm::find_compliance(
    const std::function<bool(types::global_dof_index)> &is_held,
    const unsigned int                                  own,
    const unsigned int                                  d)
  {
    const auto held = [&](const unsigned int node) {
      return is_held(surfaces.node(node).unknowns[d]);
    };
    std::set<unsigned int> around;
    for (const unsigned int face : point(own).facets)
      surfaces.add_slave_nodes(face, around);
    const bool all_held       = std::all_of(around.begin(), around.end(), held);
    const bool is_fixed       = held(point(own).node);
    const bool reaches_others = !all_held && !description.dual_multipliers;

    if (!is_fixed)
      free[own].push_back(d);
    driven[own] = driven[own] || all_held;
    if (is_fixed || shared[own])
      compliance[own][d] = reaches_others ? neighbour_compliance :
                           is_fixed       ? vanishing_compliance :
                                            shared_compliance;
    if (is_fixed && reaches_others && !shared[own])
      {
        leaning[own].leans[d] = true;
        leaning[own].points   = neighbours(own);
      }
  }

  /// Points of the same faces.
  std::vector<unsigned int> MortarTerm::neighbours(const unsigned int own) const
  {
    std::set<unsigned int> points;
    for (const unsigned int face : point(own).facets)
      for (unsigned int a = 0; a < surfaces.slave().facet(face).n_nodes; ++a)
        points.insert(surfaces.point_of(face, a));
    points.erase(surfaces.own_points()[own]);
    return {points.begin(), points.end()};
  }

  Tensor<2, 3> MortarTerm::Leaning::share() const
  {
    Tensor<2, 3> result;
    for (unsigned int d = 0; d < 3; ++d)
      result[d][d] = leans[d] ? 1. / points.size() : 0.;
    return result;
  }

  Tensor<1, 3> MortarTerm::leaned_on(const Configuration &state,
                                     const unsigned int   own) const
  {
    Tensor<1, 3> sum;
    for (const unsigned int point : leaning[own].points)
      for (unsigned int d = 0; d < surfaces.dim(); ++d)
        sum[d] += state.u(first_unknown_of(point) + d);
    return leaning[own].points.empty() ? sum : leaning[own].share() * sum;
  }
} // namespace demold

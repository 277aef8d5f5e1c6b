// SPDX-License-Identifier: LGPL-2.1-or-later
// Bonds of the mortar term as path following sees them.
#include "mortar/mortar_term.h"

#include "adhesion/radial_gap.h"

#include <algorithm>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// d(effective gap)/d(gap) [-] along the direction in which the law opens a
    /// bond under lambda_hat. The gap itself is no guide to it: it is 0 up to
    /// the onset (theory D.2).
    Tensor<1, 3> opening_direction(const SeenByLaw         &seen,
                                   const ResolventResponse &softens,
                                   const Tensor<1, 3>      &normal,
                                   const ModeFactors       &factors)
    {
      const AugmentedTraction &traction = seen.traction;
      if (!traction.is_pressed())
        {
          const Tensor<1, 3> p = traction.normal * normal +
                                 factors.b / factors.a * traction.tangential;
          const Tensor<1, 3> m = p / std::max(p.norm(), 1e-300);
          return m + (factors.b - 1.) * (m - (m * normal) * normal);
        }
      const double size = softens.gap_T.norm();
      Tensor<1, 3> along =
        size > 0. ?
          softens.gap_T / size :
          traction.tangential / std::max(traction.tangential.norm(), 1e-300);
      if (along * traction.tangential < 0.) // softening backwards
        along *= -1.;
      return factors.b * along;
    }

    /// The bond of history @p old at @p input, which covers @p area [mm^2]. The
    /// unknowns are left to the caller.
    SofteningSite bond_site(const TractionResolvent &resolvent,
                            const ConstraintInput   &input,
                            const ResolventState    &old,
                            const double             area,
                            const bool               driven)
    {
      const AdhesionLaw      &law  = *resolvent.adhesion;
      const SeenByLaw         seen = seen_by_law(resolvent, input, old);
      const ResolventResponse free =
        resolvent.evaluate(seen.traction, seen.old);
      const ResolventResponse softens =
        resolvent.evaluate(seen.traction, seen.old, ForcedBranch::decohesion);
      const PointSoftening softening{law.softening, old.bond.strength_factor};
      const double         before = softening.at(old.bond.kappa).dissipated;

      SofteningSite site;
      site.gap     = seen.gap;
      site.old_gap = input.old_gap;
      site.direction =
        opening_direction(seen, softens, input.normal, resolvent.factors());
      site.effective   = site.direction * seen.gap;
      site.largest     = old.bond.kappa;
      site.rupture     = law.rupture_gap();
      site.area        = area;
      site.whole       = area * softening.fracture_energy();
      site.left        = site.whole - area * before;
      site.utilisation = free.utilisation;
      site.driven      = driven;
      site.separated   = free.bond == AdhesionStatus::separated;
      if (driven || free.bond == AdhesionStatus::decohesion)
        {
          const SofteningPoint at = softening.at(site.effective);
          site.released           = area * (at.dissipated - before);
          site.released_gradient =
            area * loss_rate(at, site.effective) * site.direction;
        }
      else if (site.separated)
        site.released = site.left;
      return site;
    }
  } // namespace

  std::vector<unsigned int> MortarTerm::points_that_hold() const
  {
    std::vector<unsigned int> list;
    for (unsigned int own = 0; own < committed.size(); ++own)
      if (resolvent.holds(committed[own].law))
        list.push_back(own);
    return list;
  }

  /// Released energy is counted by the gap of the nodes, which is that of the
  /// law once Newton has converged. What turns the anchor on a deformable
  /// master and what strains a compliance is left out of its derivative.
  std::vector<SofteningSite> MortarTerm::softening_sites() const
  {
    std::vector<SofteningSite> list;
    for (const unsigned int own : points_that_hold())
      {
        const NodalRow &row  = frozen[own].row;
        SofteningSite   site = bond_site(resolvent,
                                       inputs[own],
                                       committed[own].law,
                                       row.area,
                                       !on_path.empty() && on_path[own]);
        const auto      add  = [&](const types::global_dof_index unknown,
                             const unsigned int            component,
                             const double                  weight) {
          site.unknowns.push_back(unknown);
          site.components.push_back(component);
          site.weights.push_back(weight);
        };
        // First what tells the points of one node apart, though it moves
        // nothing; a condensed multiplier has no unknown.
        if (!is_condensed())
          add(first_unknown(own), 0, 0.);
        for (std::size_t k = 0; k < row.nodes.size(); ++k)
          if (!surfaces.is_rigid(row.nodes[k]))
            for (unsigned int d = 0; d < surfaces.dim(); ++d)
              add(surfaces.node(row.nodes[k]).unknowns[d],
                  d,
                  row.weights[k] / row.area);
        list.push_back(site);
      }
    return list;
  }

  void MortarTerm::drive(const std::vector<bool> &points)
  {
    const auto list = points_that_hold();
    AssertDimension(points.size(), list.size());
    on_path.assign(committed.size(), false);
    for (std::size_t k = 0; k < list.size(); ++k)
      on_path[list[k]] = points[k];
  }
} // namespace demold

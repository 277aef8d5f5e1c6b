// SPDX-License-Identifier: LGPL-2.1-or-later
// On which branch of its softening law a bond is, seen as a scalar.
#include "adhesion/bond_branch.h"

#include "adhesion/viscous_damage.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  namespace
  {
    template <typename Law>
    double separation_gap_of(const Law &law)
    {
      return (1. - 1e-9) * law.rupture_gap();
    }



    // Loss up to a point of the softening branch: C6 if the bond unloads to
    // the origin, integral of s dg_d if it unloads with slope gamma.
    template <typename Law>
    double loss(const Law              &law,
                const AdhesionUnloading unloading,
                const SofteningPoint   &at,
                const double            kappa)
    {
      if (unloading == AdhesionUnloading::damage)
        return at.dissipated;
      return at.dissipated + 0.5 * at.limit * (kappa - at.limit / law.penalty);
    }



    // The softening branch starts at the onset, and a dragged anchor never
    // goes back: below that, only the value stops, the slopes go on.
    template <typename Law>
    void soften(const Law              &law,
                const AdhesionUnloading unloading,
                const double            effective,
                const double            offset,
                const double            least,
                const double            lost_before,
                BondBranch             &branch)
    {
      const bool           plastic = unloading == AdhesionUnloading::plastic;
      const double         stretch = std::max(effective, least);
      const double         kappa   = offset + stretch;
      const SofteningPoint at      = law.on_curve(kappa);

      branch.reached   = kappa;
      branch.kappa     = std::clamp(kappa, branch.kappa, law.rupture_gap());
      branch.stiffness = at.limit / stretch;
      branch.softening = (at.slope - branch.stiffness) / (stretch * stretch);
      branch.elastic   = plastic ? branch.stiffness / law.penalty : 1.;
      branch.lost_rate = plastic ? at.limit * (1. - at.slope / law.penalty) :
                                   loss_rate(at, kappa);
      branch.lost      = loss(law, unloading, at, kappa) - lost_before +
                    branch.lost_rate * (effective - stretch);
    }



    // The same where damage takes time: the gap is ahead of it, so that the
    // secant carries more than the limit. Without a dragged anchor.
    template <typename Law>
    void soften_slowly(const Law   &law,
                       const double effective,
                       const double start,
                       const double reach,
                       const double lost_before,
                       BondBranch  &branch)
    {
      const double         stretch = std::max(effective, law.onset_gap());
      const DamageReached  damage  = viscous_damage(start, stretch, reach);
      const SofteningPoint at      = law.on_curve(damage.kappa);

      branch.reached    = damage.kappa;
      branch.kappa_rate = damage.rate;
      branch.kappa = std::clamp(damage.kappa, branch.kappa, law.rupture_gap());
      branch.stiffness = at.limit / damage.kappa;
      branch.softening =
        (at.slope - branch.stiffness) / damage.kappa * damage.rate / stretch;
      branch.lost_rate = loss_rate(at, damage.kappa) * damage.rate;
      branch.lost =
        at.dissipated - lost_before + branch.lost_rate * (effective - stretch);
    }



    template <typename Law>
    BondBranch find_branch_of(const Law                          &law,
                              const AdhesionUnloading             unloading,
                              const double                        effective,
                              const double                        kappa_old,
                              const double                        reach,
                              const std::optional<AdhesionStatus> forced)
    {
      using Status = AdhesionStatus;
      BondBranch branch;
      branch.kappa = kappa_old;
      if (kappa_old >= separation_gap_of(law))
        return branch;

      const bool           intact   = kappa_old <= law.onset_gap();
      const bool           plastic  = unloading == AdhesionUnloading::plastic;
      const double         at_least = std::max(kappa_old, law.onset_gap());
      const SofteningPoint before   = law.on_curve(at_least);
      const double         lost_before =
        intact ? 0. : loss(law, unloading, before, kappa_old);

      // Gap up to which nothing more is lost, and what lies behind the anchor.
      const double limit_gap =
        plastic && !intact ? before.limit / law.penalty : at_least;
      const double offset  = plastic ? at_least - limit_gap : 0.;
      const Status elastic = intact ? Status::adhering : Status::unloading;
      const bool   slow    = std::isfinite(reach);
      const double reached =
        slow ? viscous_damage(at_least, effective, reach).kappa :
               offset + effective;

      Status free = Status::decohesion;
      if (effective <= limit_gap)
        free = elastic;
      else if (reached >= separation_gap_of(law))
        free = Status::separated;
      branch.status = forced.value_or(free);
      if (branch.status == Status::adhering ||
          branch.status == Status::unloading)
        branch.status = elastic;
      branch.consistent  = branch.status == free;
      branch.utilisation = effective / limit_gap;

      switch (branch.status)
        {
          case Status::separated:
            branch.reached = reached;
            branch.kappa   = law.rupture_gap();
            branch.lost    = law.fracture_energy() - lost_before;
            break;
          case Status::decohesion:
            if (slow)
              {
                soften_slowly(law,
                              effective,
                              at_least,
                              reach,
                              lost_before,
                              branch);
                break;
              }
            soften(law,
                   unloading,
                   effective,
                   offset,
                   plastic ? limit_gap : law.onset_gap(),
                   lost_before,
                   branch);
            break;
          case Status::adhering:
          case Status::unloading:
            branch.stiffness = plastic ? law.penalty : law.secant(kappa_old);
        }
      return branch;
    }
  } // namespace



  double separation_gap(const Softening &softening)
  {
    return std::visit([](const auto &law) { return separation_gap_of(law); },
                      softening);
  }



  double loss_rate(const SofteningPoint &at, const double kappa)
  {
    return 0.5 * (at.limit - at.slope * kappa);
  }



  BondBranch find_branch(const Softening                    &softening,
                         const AdhesionUnloading             unloading,
                         const double                        effective,
                         const double                        kappa_old,
                         const double                        reach,
                         const std::optional<AdhesionStatus> forced)
  {
    return std::visit(
      [&](const auto &law) {
        return find_branch_of(law,
                              unloading,
                              effective,
                              kappa_old,
                              reach,
                              forced);
      },
      softening);
  }
} // namespace demold

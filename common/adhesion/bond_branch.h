// SPDX-License-Identifier: LGPL-2.1-or-later
// On which branch of its softening law a bond is, seen as a scalar.
#ifndef demold_adhesion_bond_branch_h
#define demold_adhesion_bond_branch_h

#include "adhesion/softening.h"

#include <optional>

namespace demold
{
  /// Numbered as in theory C.5.
  enum class AdhesionStatus
  {
    adhering   = 0, ///< intact, slope gamma
    decohesion = 1, ///< on the softening branch
    unloading  = 2, ///< damaged, below the softening branch
    separated  = 3  ///< no traction
  };

  /// How a damaged bond unloads.
  enum class AdhesionUnloading
  {
    damage, ///< secant to the origin, anchor fixed
    plastic ///< slope gamma, anchor dragged along
  };

  /// The bond reduced to its effective gap, for strength factor one. kappa is
  /// the effective gap, plus the decohesion gap where the anchor is dragged.
  struct BondBranch
  {
    AdhesionStatus status = AdhesionStatus::separated;
    /// Largest gap, history after the increment [mm].
    double kappa = 0.;
    /// k, traction over effective gap [MPa/mm].
    double stiffness = 0.;
    /// dk/d(effective gap)/effective gap [MPa/mm^3]; softening branch only.
    double softening = 0.;
    /// Part of the gap that stays elastic; less than one if the anchor moves.
    double elastic = 1.;
    /// Loss in the increment, without mode factor [mJ/mm^2].
    double lost = 0.;
    /// d(lost)/d(effective gap) [MPa]; softening branch only.
    double lost_rate = 0.;
    /// dkappa/d(effective gap) [-]; softening branch only. Less than one if
    /// damage takes time.
    double kappa_rate = 1.;
    /// kappa, not cut at rupture [mm]; only where damage grows.
    double reached = 0.;
    /// Effective gap over the one where damage (goes on to) grow [-].
    double utilisation = 0.;
    /// False if the branch was forced against the gap.
    bool consistent = true;
  };

  /// kappa [mm] from which on a bond counts as separated: next to nothing
  /// left is nothing (theory C.4, Newton rules).
  double separation_gap(const Softening &softening);

  /// dD/dkappa [MPa] on the softening branch, theory C6.
  double loss_rate(const SofteningPoint &at, const double kappa);

  /// @param effective [mm] present effective gap, from the anchor.
  /// @param reach [mm] of damage in the increment, see viscous_damage();
  /// infinite if damage takes no time, and always with a dragged anchor.
  BondBranch find_branch(const Softening                    &softening,
                         const AdhesionUnloading             unloading,
                         const double                        effective,
                         const double                        kappa_old,
                         const double                        reach,
                         const std::optional<AdhesionStatus> forced);
} // namespace demold

#endif

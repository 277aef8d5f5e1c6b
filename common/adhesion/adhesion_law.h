// SPDX-License-Identifier: LGPL-2.1-or-later
// The bond of one point: gap vector and history in, traction and history out.
#ifndef demold_adhesion_adhesion_law_h
#define demold_adhesion_adhesion_law_h

#include "adhesion/bond_branch.h"
#include "adhesion/mode_mixing.h"

#include <deal.II/base/tensor.h>

#include <limits>
#include <optional>

namespace demold
{
  /// History of one bonded point; the default is a fresh, intact bond.
  struct AdhesionState
  {
    /// Largest effective gap so far [mm]; 0 while intact, rupture gap once
    /// separated.
    double kappa = 0.;
    /// Lost per area so far [mJ/mm^2], all bonds of the point together.
    double dissipated = 0.;
    /// Strength over the strength of the law [-]: re-adhesion, or a seeded
    /// imperfection. Scales traction and energies, not gaps.
    double strength_factor = 1.;
    /// How long pressure has held the separated point [s].
    double pressed_time = 0.;
    /// Gap vector from the anchor at the end of the increment [mm].
    dealii::Tensor<1, 3> gap;

    /// Boost.Serialization.
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &kappa &dissipated &strength_factor &pressed_time &gap;
    }
  };

  /// omega of theory C.3: which part of the pressure rubs while bonded.
  enum class FrictionWeight
  {
    full,             ///< 1: friction adds to adhesion
    damaged_fraction, ///< D/G_c, which is g_d/delta for linear softening
    after_rupture     ///< 0, then 1
  };

  /// What one evaluation gives.
  struct AdhesionResponse
  {
    /// t_a [MPa], theory C4; acts on the slave as -t_a.
    dealii::Tensor<1, 3> traction;
    /// dt_a/dg at fixed normal [MPa/mm], theory C7.
    dealii::Tensor<2, 3> dt_dg;
    /// dt_a/dn at fixed gap [MPa], for tangential dn; times n it is zero.
    dealii::Tensor<2, 3> dt_dn;
    /// By how much the anchor moves when the increment is accepted [mm]; zero
    /// but for plastic unloading.
    dealii::Tensor<1, 3> anchor_shift;
    /// psi per area [mJ/mm^2].
    double stored = 0.;
    /// Lost in this increment per area [mJ/mm^2], for the ledger.
    double dissipated_increment = 0.;
    /// Taken by viscous damage in this increment, beyond the above, per area
    /// [mJ/mm^2]; never negative.
    double regularisation_increment = 0.;
    /// D(kappa) - D(kappa_old) without mode factor [mJ/mm^2]: path parameter
    /// of dissipation control, theory D.2 (B); may be negative in forced
    /// decohesion. Equals dissipated_increment where a = b^2.
    double path_increment = 0.;
    /// d(path_increment)/dg [MPa]; zero unless in decohesion.
    dealii::Tensor<1, 3> path_gradient;
    /// dkappa/dg [-]; zero unless in decohesion.
    dealii::Tensor<1, 3> dkappa_dg;
    /// Effective gap over the one where damage (goes on to) grow [-].
    double utilisation = 0.;
    /// The branch used.
    AdhesionStatus status = AdhesionStatus::adhering;
    /// False if a forced branch is not the one the gap asks for: such a point
    /// must not be accepted.
    bool consistent = true;
    /// History if the increment is accepted.
    AdhesionState state;
  };

  /// Adhesion between a point and its anchor on the mould: softening law,
  /// mixed mode, unloading and re-adhesion. Theory C.2 to C.5.
  ///
  /// Compression neither heals nor damages and is not resisted: only <g_N>
  /// enters; at g_N = 0 the tangent is that of opening, so that an unloaded
  /// bond already holds. The penalty of the softening law must be finite here.
  ///
  /// Plastic unloading drags the anchor along the gap until the bond carries
  /// its tension limit with slope gamma, x_a <- x_s - t_a/gamma (for a = 1;
  /// only tangentially while closed). Its loss is rho times the integral of
  /// s dg_d, exact for straight sliding or opening and never negative.
  ///
  /// With a viscous time damage lags behind the gap (viscous_damage.h) and
  /// takes work beyond G_c, at steady opening 2 x + x^2 of it, x = tau_v
  /// kappa'/delta. A law knows how long an increment is by over(); as made, it
  /// is the one without viscosity. Damage-like unloading only. Where a != b^2
  /// the modes of the end of the increment count for the whole of it.
  struct AdhesionLaw
  {
    Softening         softening;
    ModeFactors       factors;
    AdhesionUnloading unloading       = AdhesionUnloading::damage;
    FrictionWeight    friction        = FrictionWeight::full;
    double            rest_pressure   = 0.; ///< p_re [MPa]
    double            rest_time       = 0.; ///< t_re [s]
    double            rest_efficiency = 0.; ///< eta_re [-], 0 = never
    double            viscous_time    = 0.; ///< tau_v [s], 0 = no viscosity
    /// delta dt/tau_v [mm] of the increment.
    double reach = std::numeric_limits<double>::infinity();

    /// The law over an increment in which @p elapsed [s] pass for the material:
    /// the same without viscous time. In no time at all damage stands still.
    AdhesionLaw over(const double elapsed) const;

    /// @param gap [mm] slave point minus anchor, @param normal unit, out of
    /// the mould. @param forced takes that branch whatever the gap says (to
    /// break cycling, or to predict onset): decohesion is then continued
    /// beyond rupture and, from the loading side, below the present damage.
    /// A separated point stays separated.
    AdhesionResponse
    evaluate(const dealii::Tensor<1, 3>         &gap,
             const dealii::Tensor<1, 3>         &normal,
             const AdhesionState                &old,
             const std::optional<AdhesionStatus> forced = {}) const;

    /// Is dt_dg symmetric on every branch: a = b^2.
    bool symmetric() const;

    /// Work of separation [mJ/mm^2] along a straight path at @p mode_angle
    /// [rad] to the normal: G_c (cos^2 + a sin^2)/(cos^2 + b^2 sin^2),
    /// theory C.2, exact for every penalty.
    double fracture_energy(const double mode_angle = 0.) const;

    /// g_0 [mm].
    double onset_gap() const;

    /// Effective gap of separation [mm].
    double rupture_gap() const;

    /// omega(kappa) [-], theory C.3.
    double friction_weight(const double kappa) const;

    /// d omega/d kappa [1/mm].
    double friction_weight_derivative(const double kappa) const;

    /// Re-adhesion, theory C.5: the history after @p time_step [s] under
    /// @p pressure [MPa]. When a separated point has been pressed by more
    /// than p_re for t_re its kappa comes back as 0 and the caller takes the
    /// present projection as new anchor.
    AdhesionState rested(const AdhesionState &state,
                         const double         pressure,
                         const double         time_step) const;
  };
} // namespace demold

#endif

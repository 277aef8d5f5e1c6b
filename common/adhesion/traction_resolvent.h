// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact, friction and adhesion of one point as a map from traction to gap.
#ifndef demold_adhesion_traction_resolvent_h
#define demold_adhesion_traction_resolvent_h

#include "adhesion/adhesion_law.h"

#include <deal.II/base/tensor.h>

#include <optional>

namespace demold
{
  /// How a point meets the mould, numbered as in theory C.5.
  enum class ContactStatus
  {
    closed = 4, ///< under pressure: sticks, or has no friction at all
    slip   = 5, ///< under pressure: slides against friction
    open   = 6  ///< no pressure; a bond that holds may be in tension
  };

  /// Branch taken whatever the traction says.
  enum class ForcedBranch
  {
    hold,      ///< slip of t_n under pressure, else the bond as of t_n
    decohesion ///< softening branch, also below the limit and beyond rupture
  };

  /// lambda_hat = lambda + C g, C = diag(c_N, c_T, c_T): theory C.4.
  struct AugmentedTraction
  {
    /// lambda_N + c_N g_N [MPa], tension positive.
    double normal = 0.;
    /// lambda_T + c_T g_T [MPa], in the tangent plane. g_T is the whole slip
    /// from the anchor while a bond holds, else the slip of the increment.
    dealii::Tensor<1, 3> tangential;
    /// Which rows hold, where something else than the sign of normal decides.
    std::optional<bool> pressed;

    bool is_pressed() const
    {
      return pressed.value_or(normal <= 0.);
    }
  };

  /// History of one point; the default is a point without bond, open.
  struct ResolventState
  {
    /// kappa, loss, strength factor, time under pressure. Its gap vector is
    /// not used: opening and slip take its place.
    AdhesionState bond;
    /// Was there ever a bond? It holds until kappa is the rupture gap.
    bool bonded = false;
    /// Closed at t_n. A point that was open closes without friction in its
    /// first increment (theory C.4, re-contact).
    bool may_stick = false;
    /// g_N at t_n [mm]; 0 without a bond that holds.
    double opening = 0.;
    /// g_T at t_n [mm], whole slip from the anchor, turned by the caller into
    /// the present tangent plane; 0 without a bond that holds.
    dealii::Tensor<1, 3> slip;
    /// Limit of friction at t_n [MPa].
    double friction_limit = 0.;
    /// Lost by friction so far per area [mJ/mm^2].
    double friction_loss = 0.;

    /// Boost.Serialization.
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &bond.kappa &bond.dissipated &bond.strength_factor &bond
        .pressed_time &bonded &may_stick &opening &slip &friction_limit
          &friction_loss;
    }
  };

  /// What one evaluation gives. Derivatives are those of the branch taken;
  /// the tensors act on tangential vectors and give tangential vectors.
  struct ResolventResponse
  {
    double               gap_N = 0.; ///< g_N [mm], never negative
    dealii::Tensor<1, 3> gap_T;      ///< g_T [mm]

    double               dN_dN = 0.; ///< dg_N/dlambda_hat_N [mm/MPa]
    dealii::Tensor<1, 3> dN_dT;      ///< dg_N/dlambda_hat_T [mm/MPa]
    dealii::Tensor<1, 3> dT_dN;      ///< dg_T/dlambda_hat_N [mm/MPa]
    dealii::Tensor<2, 3> dT_dT;      ///< dg_T/dlambda_hat_T [mm/MPa]
    /// dg_T/dg_T^n [-]: the slip at t_n turns with the normal.
    dealii::Tensor<2, 3> dT_dslip;

    AdhesionStatus bond    = AdhesionStatus::separated;
    ContactStatus  contact = ContactStatus::open;
    /// Unit direction of sliding against friction, 0 without.
    dealii::Tensor<1, 3> slide;
    /// False if a forced branch is not the one the traction asks for: such a
    /// point must not be accepted.
    bool consistent = true;
    /// How near decohesion is [-], 1 once there (theory D.2); 0 if separated.
    double utilisation = 0.;

    /// psi per area [mJ/mm^2].
    double stored = 0.;
    /// Lost by the bond in this increment per area [mJ/mm^2]: integral of
    /// traction times d(gap) along a straight gap path less what is stored.
    double dissipated_increment = 0.;
    /// Lost by friction in this increment per area [mJ/mm^2]: (L_n + L)/2
    /// times slip, exact where the limit changes linearly over the slip.
    double friction_increment = 0.;
    /// D(kappa) - D(kappa_old) without mode factor [mJ/mm^2], path parameter
    /// of theory D.2 (B); negative if decohesion is forced below the limit.
    double path_increment = 0.;
    /// Its derivatives by the augmented traction [mm]; 0 unless in decohesion.
    double               dpath_dN = 0.;
    dealii::Tensor<1, 3> dpath_dT;

    /// History if the increment is accepted.
    ResolventState state;

    /// State number of theory C.5: the bond while it holds and does not slip
    /// against friction, else contact.
    int number() const;
  };

  /// Point law of contact with Lagrange multipliers, theory C.4: the limit
  /// gamma -> infinity of AdhesionLaw in parallel with unilateral contact and
  /// Coulomb friction, g = G(lambda_hat). Single-valued and Lipschitz with
  /// 1/(c_N - steepest softening) (C8). Unloading is damage-like.
  ///
  /// The friction weight omega (theory C.3) is that of the damage at t_n.
  struct TractionResolvent
  {
    /// Softening, mixing, friction weight and re-adhesion; its softening must
    /// be rigid_softening(). Without, factors are a = b = 1.
    std::optional<AdhesionLaw> adhesion;
    double                     friction = 0.; ///< mu [-]
    double                     penalty  = 1.; ///< c_N [MPa/mm]

    /// a and b of the mixing; 1 without adhesion.
    ModeFactors factors() const;

    /// c_T = a c_N [MPa/mm].
    double tangential_penalty() const;

    /// Bound of c_N that the program keeps [MPa/mm]: 5 times the steepest
    /// softening; C8 holds from once. 0 without adhesion.
    double smallest_penalty() const;

    /// Does the point have a bond that is not ruptured?
    bool holds(const ResolventState &state) const;

    /// A point that has just been bonded.
    ResolventState fresh_bond() const;

    ResolventResponse
    evaluate(const AugmentedTraction          &traction,
             const ResolventState             &old,
             const std::optional<ForcedBranch> forced = {}) const;

    /// Re-adhesion, theory C.5, see AdhesionLaw::rested(): a fresh bond where
    /// kappa comes back as 0.
    ResolventState rested(const ResolventState &state,
                          const double          pressure,
                          const double          time_step) const;
  };
} // namespace demold

#endif

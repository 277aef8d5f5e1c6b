// SPDX-License-Identifier: LGPL-2.1-or-later
// The bond of one point: gap vector and history in, traction and history out.
#include "adhesion/adhesion_law.h"

#include "adhesion/gap_path.h"
#include "adhesion/viscous_damage.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    // The gap split by the normal. v is the direction of the traction, w the
    // direction in which the effective gap grows (theory C7).
    struct Split
    {
      double       opening;   // g_N
      double       open;      // H(g_N), one at contact
      double       effective; // sqrt(<g_N>^2 + b^2 |g_T|^2)
      double       ratio;     // (<g_N>^2 + a |g_T|^2)/effective^2
      Tensor<1, 3> slip;      // g_T
      Tensor<1, 3> v;
      Tensor<1, 3> w;
    };

    Split split_gap(const Tensor<1, 3> &gap,
                    const Tensor<1, 3> &normal,
                    const ModeFactors  &factors)
    {
      Split        s;
      const double b2       = factors.b * factors.b;
      s.opening             = gap * normal;
      s.open                = s.opening >= 0. ? 1. : 0.;
      s.slip                = gap - s.opening * normal;
      s.v                   = s.open * s.opening * normal + factors.a * s.slip;
      s.w                   = s.open * s.opening * normal + b2 * s.slip;
      const double opening2 = s.open * s.opening * s.opening;
      const double slip2    = s.slip.norm_square();
      s.effective           = std::sqrt(opening2 + b2 * slip2);
      s.ratio               = s.effective > 0. ?
                                (opening2 + factors.a * slip2) / (opening2 + b2 * slip2) :
                                1.;
      return s;
    }



    // Theory C7 and its companion for a turning normal: g_N changes by g.dn,
    // g_T by -(g.dn) n - g_N dn.
    void add_tangents(const Split        &s,
                      const Tensor<1, 3> &normal,
                      const ModeFactors  &factors,
                      const double        k,
                      const double        dk,
                      AdhesionResponse   &r)
    {
      const Tensor<2, 3> nn = outer_product(normal, normal);
      Tensor<2, 3>       within;
      for (unsigned int d = 0; d < 3; ++d)
        within[d][d] = 1.;
      within -= nn;
      const Tensor<1, 3> grown =
        (s.open - factors.b * factors.b) * s.opening * s.slip;

      r.dt_dg =
        k * (s.open * nn + factors.a * within) + dk * outer_product(s.v, s.w);
      r.dt_dn = k * (s.open - factors.a) *
                  (outer_product(normal, s.slip) + s.opening * within) +
                dk * outer_product(s.v, grown);
    }



    // What viscous damage has taken, for strength and mode factor one.
    // @p effective_old of t_n, maybe ahead of the damage then already.
    double taken_by_viscosity(const AdhesionLaw &law,
                              const BondBranch  &branch,
                              const double       effective_old,
                              const double       kappa_old)
    {
      const double start = std::max(kappa_old, law.onset_gap());
      if (!(branch.reached > start))
        return 0.;
      return overstress_work(law.softening,
                             start,
                             branch.reached,
                             std::max(0., effective_old / start - 1.),
                             (branch.reached - start) / law.reach);
    }
  } // namespace



  AdhesionLaw AdhesionLaw::over(const double elapsed) const
  {
    AdhesionLaw law = *this;
    if (viscous_time > 0.)
      law.reach = std::visit([](const auto &s) { return s.gap; }, softening) *
                  elapsed / viscous_time;
    return law;
  }



  AdhesionResponse
  AdhesionLaw::evaluate(const Tensor<1, 3>                 &gap,
                        const Tensor<1, 3>                 &normal,
                        const AdhesionState                &old,
                        const std::optional<AdhesionStatus> forced) const
  {
    const Split      s = split_gap(gap, normal, factors);
    const BondBranch branch =
      find_branch(softening, unloading, s.effective, old.kappa, reach, forced);
    const bool viscous = std::isfinite(reach);

    const double scale = old.strength_factor;
    const double k     = scale * branch.stiffness;
    const double dk    = scale * branch.softening;

    AdhesionResponse r;
    r.status      = branch.status;
    r.consistent  = branch.consistent;
    r.utilisation = branch.utilisation;
    r.traction    = k * s.v;
    add_tangents(s, normal, factors, k, dk, r);
    r.stored = 0.5 * k * branch.elastic * s.ratio * s.effective * s.effective;
    r.path_increment = scale * branch.lost;
    if (r.status == AdhesionStatus::decohesion && s.effective > 0.)
      {
        const Tensor<1, 3> grown = s.w / s.effective;
        r.dkappa_dg              = branch.kappa_rate * grown;
        r.path_gradient          = scale * branch.lost_rate * grown;
        r.anchor_shift =
          (1. - branch.elastic) * (s.open * s.opening * normal + s.slip);
      }

    // One ratio of modes fits the whole increment but for damage with a mixing
    // that has no potential: there the path counts.
    const bool path_counts = !symmetric() &&
                             unloading == AdhesionUnloading::damage &&
                             !viscous && branch.consistent && branch.lost > 0.;
    r.dissipated_increment =
      path_counts ? scale * decohesion_work({old.gap, gap, normal, factors},
                                            softening,
                                            old.kappa,
                                            branch.lost) :
                    s.ratio * r.path_increment;
    if (viscous)
      r.regularisation_increment =
        scale * s.ratio *
        taken_by_viscosity(*this,
                           branch,
                           split_gap(old.gap, normal, factors).effective,
                           old.kappa);

    r.state            = old;
    r.state.kappa      = branch.kappa;
    r.state.dissipated = old.dissipated + r.dissipated_increment;
    r.state.gap        = gap - r.anchor_shift;
    return r;
  }



  bool AdhesionLaw::symmetric() const
  {
    return std::abs(factors.a - factors.b * factors.b) <= 1e-14 * factors.a;
  }



  double AdhesionLaw::fracture_energy(const double mode_angle) const
  {
    const double c = std::cos(mode_angle) * std::cos(mode_angle);
    const double s = std::sin(mode_angle) * std::sin(mode_angle);
    return std::visit([](const auto &law) { return law.fracture_energy(); },
                      softening) *
           (c + factors.a * s) / (c + factors.b * factors.b * s);
  }



  double AdhesionLaw::onset_gap() const
  {
    return std::visit([](const auto &law) { return law.onset_gap(); },
                      softening);
  }



  double AdhesionLaw::rupture_gap() const
  {
    return std::visit([](const auto &law) { return law.rupture_gap(); },
                      softening);
  }



  double AdhesionLaw::friction_weight(const double kappa) const
  {
    switch (friction)
      {
        case FrictionWeight::damaged_fraction:
          return std::visit(
            [&](const auto &law) {
              return law.dissipated(kappa) / law.fracture_energy();
            },
            softening);
        case FrictionWeight::after_rupture:
          return kappa < separation_gap(softening) ? 0. : 1.;
        case FrictionWeight::full:
          break;
      }
    return 1.;
  }



  double AdhesionLaw::friction_weight_derivative(const double kappa) const
  {
    if (friction != FrictionWeight::damaged_fraction || kappa <= onset_gap() ||
        kappa >= rupture_gap())
      return 0.;
    return std::visit(
      [&](const auto &law) {
        return loss_rate(law.on_curve(kappa), kappa) / law.fracture_energy();
      },
      softening);
  }



  AdhesionState AdhesionLaw::rested(const AdhesionState &state,
                                    const double         pressure,
                                    const double         time_step) const
  {
    AdhesionState next = state;
    if (rest_efficiency <= 0. || pressure <= rest_pressure ||
        state.kappa < separation_gap(softening))
      {
        next.pressed_time = 0.;
        return next;
      }
    next.pressed_time += time_step;
    if (next.pressed_time >= rest_time)
      {
        next.kappa        = 0.;
        next.pressed_time = 0.;
        next.gap          = Tensor<1, 3>();
        next.strength_factor *= rest_efficiency;
      }
    return next;
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact, friction and adhesion of one point as a map from traction to gap.
#include "adhesion/traction_resolvent.h"

#include "adhesion/gap_path.h"
#include "adhesion/resolvent_branch.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    // Damage next to none is none, and next to all is all (theory C.4).
    double rounded(const double kappa, const Softening &softening)
    {
      const double all = separation_gap(softening);
      if (kappa >= all)
        return std::visit([](const auto &law) { return law.rupture_gap(); },
                          softening);
      return kappa < 1e-9 * all ? 0. : kappa;
    }



    // The gap of the increment in the plane that its slips span.
    GapPath path(const ResolventState    &old,
                 const ResolventResponse &r,
                 const ModeFactors       &factors)
    {
      GapPath      path;
      const double before = old.slip.norm();
      const double along  = before > 0. ? r.gap_T * old.slip / before : 0.;
      path.normal[2]      = 1.;
      path.start[0]       = before;
      path.start[2]       = old.opening;
      path.end[0]         = along;
      path.end[1] =
        std::sqrt(std::max(r.gap_T.norm_square() - along * along, 0.));
      path.end[2]  = r.gap_N;
      path.factors = factors;
      return path;
    }



    // kappa, stored, lost and the path parameter of a point whose bond held at
    // t_n.
    void add_bond(const AdhesionLaw     &law,
                  const ResolventState  &old,
                  const ResolventBranch &branch,
                  ResolventResponse     &r)
    {
      const PointSoftening softening{law.softening, old.bond.strength_factor};
      const double         kappa_old = old.bond.kappa;
      const double         before    = softening.at(kappa_old).dissipated;
      double               lost      = 0.;
      double              &kappa     = r.state.bond.kappa;
      if (r.bond == AdhesionStatus::decohesion)
        {
          const SofteningPoint at   = softening.at(branch.effective);
          const double         rate = loss_rate(at, branch.effective);
          kappa = rounded(std::max(kappa_old, branch.effective), law.softening);
          r.path_increment = at.dissipated - before;
          r.dpath_dN       = rate * branch.deffective_dN;
          r.dpath_dT       = rate * branch.deffective_dT;
          lost             = softening.at(kappa).dissipated - before;
        }
      if (r.bond == AdhesionStatus::separated)
        {
          kappa = law.rupture_gap();
          lost = r.path_increment = softening.fracture_energy() - before;
        }
      if (kappa > 0. && kappa < law.rupture_gap())
        r.stored = 0.5 * softening.at(kappa).limit / kappa *
                   (r.gap_N * r.gap_N + law.factors.a * r.gap_T.norm_square());
      if (lost > 0.)
        r.dissipated_increment =
          law.symmetric() ? lost :
                            old.bond.strength_factor *
                              decohesion_work(path(old, r, law.factors),
                                              law.softening,
                                              kappa_old,
                                              lost / old.bond.strength_factor);
      r.state.bond.dissipated += r.dissipated_increment;
    }
  } // namespace



  int ResolventResponse::number() const
  {
    return bond != AdhesionStatus::separated && contact != ContactStatus::slip ?
             static_cast<int>(bond) :
             static_cast<int>(contact);
  }



  ModeFactors TractionResolvent::factors() const
  {
    return adhesion ? adhesion->factors : ModeFactors{};
  }



  double TractionResolvent::tangential_penalty() const
  {
    return factors().a * penalty;
  }



  double TractionResolvent::smallest_penalty() const
  {
    return adhesion ?
             5. *
               std::visit([](const auto &law) { return law.steepest_slope(); },
                          adhesion->softening) :
             0.;
  }



  bool TractionResolvent::holds(const ResolventState &state) const
  {
    return state.bonded && adhesion &&
           state.bond.kappa < separation_gap(adhesion->softening);
  }



  ResolventState TractionResolvent::fresh_bond() const
  {
    ResolventState state;
    state.bonded    = true;
    state.may_stick = true;
    return state;
  }



  ResolventResponse
  TractionResolvent::evaluate(const AugmentedTraction          &traction,
                              const ResolventState             &old,
                              const std::optional<ForcedBranch> forced) const
  {
    Assert(!adhesion || adhesion->onset_gap() == 0.,
           ExcMessage("The softening must be rigid."));
    const bool   held    = holds(old);
    const bool   pressed = traction.is_pressed();
    const double weight = held ? adhesion->friction_weight(old.bond.kappa) : 1.;
    const double coefficient = old.may_stick ? friction * weight : 0.;

    const ResolventBranch branch =
      pressed ? pressed_branch(*this, traction, old, coefficient, forced) :
                open_branch(*this, traction, old, forced);
    ResolventResponse r = branch.response;
    r.state             = old;
    if (held)
      add_bond(*adhesion, old, branch, r);

    const double limit = pressed ? -coefficient * traction.normal : 0.;
    if (r.contact == ContactStatus::slip)
      r.friction_increment =
        0.5 * (old.friction_limit + limit) * (r.gap_T - old.slip).norm();

    const bool holds_on    = holds(r.state);
    r.state.opening        = holds_on ? r.gap_N : 0.;
    r.state.slip           = holds_on ? r.gap_T : Tensor<1, 3>();
    r.state.may_stick      = pressed || (holds_on && r.state.bond.kappa == 0.);
    r.state.friction_limit = limit;
    r.state.friction_loss += r.friction_increment;
    return r;
  }



  ResolventState TractionResolvent::rested(const ResolventState &state,
                                           const double          pressure,
                                           const double time_step) const
  {
    // Slip and opening are zero since the bond has gone.
    ResolventState next = state;
    if (adhesion && state.bonded)
      next.bond = adhesion->rested(state.bond, pressure, time_step);
    return next;
  }
} // namespace demold

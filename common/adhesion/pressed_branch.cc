// SPDX-License-Identifier: LGPL-2.1-or-later
// A point under pressure: all rows of the point law with lambda_hat_N <= 0.
#include "adhesion/resolvent_branch.h"
#include "adhesion/sliding_gap.h"

#include <algorithm>

namespace demold
{
  using namespace dealii;

  namespace
  {
    // One row with its status.
    struct Row
    {
      TangentialGap  gap;
      AdhesionStatus bond;
      double         utilisation = 0.;
    };



    Row intact_row(const PressedPoint   &p,
                   const PointSoftening &softening,
                   const bool            forced)
    {
      const double strength = softening.at(0.).limit;
      const double size     = p.traction.norm();
      const double reach    = p.factors.b / p.factors.a * (size - p.limit);
      if (reach <= strength && !(forced && softening.feels(size)))
        return {stuck(p),
                AdhesionStatus::adhering,
                std::max(reach / strength, 0.)};
      const TangentialGap softened =
        radial_slide(p, softening, SlideAxis::traction);
      if (softened.effective < separation_gap(softening.softening) || forced)
        return {softened, AdhesionStatus::decohesion, 1.};
      return {slide(p, 0.), AdhesionStatus::separated};
    }



    Row damaged_row(const PressedPoint   &p,
                    const PointSoftening &softening,
                    const double          kappa,
                    const bool            forced)
    {
      const double        b         = p.factors.b;
      const double        stiffness = softening.at(kappa).limit / kappa;
      const TangentialGap elastic   = slide(p, stiffness);
      if (!elastic.slides || b * elastic.gap.norm() <= kappa)
        {
          const SlideAxis axis = p.limit > 0. && p.start.norm() > 0. ?
                                   SlideAxis::start :
                                   SlideAxis::traction;
          if (forced &&
              (axis == SlideAxis::start || softening.feels(p.traction.norm())))
            return {radial_slide(p, softening, axis),
                    AdhesionStatus::decohesion,
                    1.};
          return {elastic,
                  AdhesionStatus::unloading,
                  b * elastic.gap.norm() / kappa * elastic.used};
        }
      const TangentialGap loose = slide(p, 0.);
      if (!forced &&
          b * loose.gap.norm() >= separation_gap(softening.softening))
        return {loose, AdhesionStatus::separated};
      return {softening_slide(p, softening, kappa),
              AdhesionStatus::decohesion,
              1.};
    }



    Row row(const PressedPoint               &p,
            const TractionResolvent          &law,
            const ResolventState             &old,
            const std::optional<ForcedBranch> forced)
    {
      const double         kappa   = old.bond.kappa;
      const bool           holds   = law.holds(old);
      const bool           soften  = forced == ForcedBranch::decohesion;
      const AdhesionStatus elastic = !holds     ? AdhesionStatus::separated :
                                     kappa > 0. ? AdhesionStatus::unloading :
                                                  AdhesionStatus::adhering;
      if (forced == ForcedBranch::hold)
        return {stuck(p), elastic};
      if (!holds)
        return {slide(p, 0.), elastic};
      const PointSoftening softening{law.adhesion->softening,
                                     old.bond.strength_factor};
      return kappa > 0. ? damaged_row(p, softening, kappa, soften) :
                          intact_row(p, softening, soften);
    }
  } // namespace



  ResolventBranch pressed_branch(const TractionResolvent          &law,
                                 const AugmentedTraction          &traction,
                                 const ResolventState             &old,
                                 const double                      coefficient,
                                 const std::optional<ForcedBranch> forced)
  {
    const PressedPoint p{traction.tangential,
                         -coefficient * traction.normal,
                         old.slip,
                         law.factors(),
                         law.penalty};
    const Row          taken = row(p, law, old, forced);
    const Row          free  = forced ? row(p, law, old, {}) : taken;

    const TangentialGap &g = taken.gap;
    ResolventBranch      branch;
    ResolventResponse   &r = branch.response;
    r.gap_T                = g.gap;
    r.dT_dT                = g.by_traction;
    r.dT_dN                = -coefficient * g.by_limit;
    r.dT_dslip             = g.by_start;
    r.bond                 = taken.bond;
    r.contact =
      g.slides && coefficient > 0. ? ContactStatus::slip : ContactStatus::closed;
    if (r.contact == ContactStatus::slip)
      r.slide = g.direction;
    r.utilisation = taken.utilisation;
    r.consistent  = taken.bond == free.bond && g.slides == free.gap.slides;
    if (taken.bond == AdhesionStatus::decohesion)
      {
        const Tensor<1, 3> e =
          g.effective > 0. ? g.gap / g.gap.norm() : g.direction;
        branch.effective     = g.effective;
        branch.deffective_dT = law.factors().b * (e * g.by_traction);
        branch.deffective_dN = law.factors().b * (e * r.dT_dN);
      }
    return branch;
  }
} // namespace demold

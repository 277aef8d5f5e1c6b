// SPDX-License-Identifier: LGPL-2.1-or-later
// A bond as path following sees it.
#include "contact/softening_site.h"

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Released per area up to @p kappa [mJ/mm^2], without mode factor.
    double released(const AdhesionLaw &law, const double kappa)
    {
      return kappa <= law.onset_gap() ?
               0. :
               std::visit([&](const auto &s) { return s.dissipated(kappa); },
                          law.softening);
    }
  } // namespace

  SofteningSite softening_site(const AdhesionLaw   &law,
                               const Tensor<1, 3>  &gap,
                               const Tensor<1, 3>  &normal,
                               const AdhesionState &old,
                               const double         area,
                               const bool           driven)
  {
    const AdhesionResponse free = law.evaluate(gap, normal, old);
    // Only the softening branch has a slope everywhere.
    const AdhesionResponse softens =
      law.evaluate(gap, normal, old, AdhesionStatus::decohesion);
    const AdhesionResponse &counted = driven ? softens : free;
    const double            scale   = area * old.strength_factor;

    SofteningSite point;
    point.gap               = gap;
    point.old_gap           = old.gap;
    point.largest           = std::max(old.kappa, law.onset_gap());
    point.effective         = free.utilisation * point.largest;
    point.direction         = softens.dkappa_dg;
    point.onset             = law.onset_gap();
    point.rupture           = law.rupture_gap();
    point.area              = area;
    point.whole             = scale * released(law, law.rupture_gap());
    point.left              = point.whole - scale * released(law, old.kappa);
    point.released          = area * counted.path_increment;
    point.released_gradient = area * counted.path_gradient;
    point.utilisation       = free.utilisation;
    point.driven            = driven;
    point.separated         = free.status == AdhesionStatus::separated;
    return point;
  }
} // namespace demold

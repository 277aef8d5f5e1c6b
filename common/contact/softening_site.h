// SPDX-License-Identifier: LGPL-2.1-or-later
// A bond as path following sees it.
#ifndef demold_contact_softening_site_h
#define demold_contact_softening_site_h

#include "adhesion/adhesion_law.h"
#include "weak_form/softening_sites.h"

namespace demold
{
  /// The bond of history @p old at the gap vector @p gap [mm] from its anchor
  /// with master normal @p normal; the unknowns are left to the caller.
  SofteningSite softening_site(const AdhesionLaw          &law,
                               const dealii::Tensor<1, 3> &gap,
                               const dealii::Tensor<1, 3> &normal,
                               const AdhesionState        &old,
                               const double                area,
                               const bool                  driven);
} // namespace demold

#endif

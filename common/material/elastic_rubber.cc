// SPDX-License-Identifier: LGPL-2.1-or-later
// Elastic rubber by its small-strain constants.
#include "material/elastic_rubber.h"

namespace demold
{
  RubberLaw elastic_rubber(const double young, const double bulk)
  {
    const double shear = 3. * bulk * young / (9. * bulk - young);
    RubberLaw    law;
    law.elastic = MooneyRivlin{bulk - 2. / 3. * shear, shear, 0.};
    return law;
  }
} // namespace demold

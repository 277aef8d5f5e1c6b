// SPDX-License-Identifier: LGPL-2.1-or-later
// Elastic rubber by its small-strain constants.
#ifndef demold_material_elastic_rubber_h
#define demold_material_elastic_rubber_h

#include "material/rubber_law.h"

namespace demold
{
  /// Mooney-Rivlin rubber (theory A1, mu2 = 0) of Young's modulus @p young and
  /// bulk modulus @p bulk at small strain [MPa], bulk > young/3; no branches.
  RubberLaw elastic_rubber(double young, double bulk);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// The only place that knows all softening laws.
#ifndef demold_adhesion_softening_h
#define demold_adhesion_softening_h

#include "adhesion/exponential_softening.h"
#include "adhesion/linear_softening.h"

#include <variant>

namespace demold
{
  /// A softening law chosen by name; visit it once per point.
  using Softening = std::variant<LinearSoftening, ExponentialSoftening>;

  /// The same law with infinite penalty: rigid until the limit, theory C.4.
  Softening rigid_softening(const Softening &softening);
} // namespace demold

#endif

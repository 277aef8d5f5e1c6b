// SPDX-License-Identifier: LGPL-2.1-or-later
// The only place that knows all softening laws.
#include "adhesion/softening.h"

#include <limits>

namespace demold
{
  Softening rigid_softening(const Softening &softening)
  {
    Softening rigid = softening;
    std::visit(
      [](auto &law) { law.penalty = std::numeric_limits<double>::infinity(); },
      rigid);
    return rigid;
  }
} // namespace demold

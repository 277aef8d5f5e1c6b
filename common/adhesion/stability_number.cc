// SPDX-License-Identifier: LGPL-2.1-or-later
// Will the bond let go in a jump: two numbers known before computing.
#include "adhesion/stability_number.h"

#include <algorithm>
#include <sstream>

namespace demold
{
  bool StabilityNumber::jumps() const
  {
    return omega > critical;
  }



  StabilityNumber stability_number(const Softening &softening,
                                   const double     modulus,
                                   const double     poisson_ratio,
                                   const double     height)
  {
    return std::visit(
      [&](const auto &law) -> StabilityNumber {
        const double steepness =
          law.strength * law.strength / law.fracture_energy();
        return {steepness * height / modulus,
                steepness / law.steepest_slope(),
                modulus / (1. - poisson_ratio * poisson_ratio) / steepness};
      },
      softening);
  }



  std::string StabilityPreview::text() const
  {
    const double zone =
      std::min(relaxed.cohesive_zone, instantaneous.cohesive_zone);
    std::ostringstream out;
    out.precision(3);
    out << "stability number Omega = strength^2 height/(G_c E): "
        << relaxed.omega << " relaxed, " << instantaneous.omega
        << " instantaneous; jumps above " << relaxed.critical << "\n  -> "
        << (instantaneous.jumps() ? "lets go in a jump at any speed" :
            relaxed.jumps() ? "steady when pulled fast, delayed rupture when "
                              "the rubber relaxes" :
                              "lets go steadily")
        << "\ncohesive zone l_cz = E/(1-nu^2) G_c/strength^2: "
        << relaxed.cohesive_zone << " mm relaxed, "
        << instantaneous.cohesive_zone
        << " mm instantaneous; interface elements up to " << zone / 3.
        << " mm resolve it\n";
    return out.str();
  }



  StabilityPreview stability_preview(const Softening &softening,
                                     const double     relaxed_modulus,
                                     const double     instantaneous_modulus,
                                     const double     poisson_ratio,
                                     const double     height)
  {
    return {stability_number(softening, relaxed_modulus, poisson_ratio, height),
            stability_number(softening,
                             instantaneous_modulus,
                             poisson_ratio,
                             height)};
  }
} // namespace demold

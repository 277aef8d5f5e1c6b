// SPDX-License-Identifier: LGPL-2.1-or-later
// Will the bond let go in a jump: two numbers known before computing.
#ifndef demold_adhesion_stability_number_h
#define demold_adhesion_stability_number_h

#include "adhesion/softening.h"

#include <string>

namespace demold
{
  /// For one modulus, theory D.1.
  struct StabilityNumber
  {
    /// Omega = alpha^2 h/(G_c E) [-].
    double omega = 0.;
    /// Omega above which a bond under a block of height h, driven by a
    /// prescribed displacement, jumps [-]: the steepest softening slope equals
    /// E/h there. 2 for linear softening, 1 for exponential, both less what
    /// the finite penalty takes.
    double critical = 0.;
    /// l_cz = E/(1-nu^2) G_c/alpha^2, length over which a front is spread [mm].
    double cohesive_zone = 0.;

    bool jumps() const;
  };

  /// @param modulus E [MPa], @param poisson_ratio nu [-], @param height h [mm]
  /// of the rubber behind the bond.
  StabilityNumber stability_number(const Softening &softening,
                                   const double     modulus,
                                   const double     poisson_ratio,
                                   const double     height);

  /// Rubber that has relaxed, and rubber loaded at once.
  struct StabilityPreview
  {
    StabilityNumber relaxed;
    StabilityNumber instantaneous;

    /// Three lines for the preview of a scene.
    std::string text() const;
  };

  /// @param relaxed_modulus E_infinity and @param instantaneous_modulus E_0
  /// [MPa].
  StabilityPreview stability_preview(const Softening &softening,
                                     const double     relaxed_modulus,
                                     const double     instantaneous_modulus,
                                     const double     poisson_ratio,
                                     const double     height);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// How shear counts beside opening: the two factors of mixed mode.
#ifndef demold_adhesion_mode_mixing_h
#define demold_adhesion_mode_mixing_h

#include <string>

namespace demold
{
  /// Theory C.2. Peak shear / peak tension, shear rupture gap / delta and
  /// G_II / G_I are a/b, 1/b and a/b^2.
  enum class ModeMixing
  {
    isotropic,   ///< 1, 1, 1: thesis, node to segment; needs beta_T = 1
    slip_limit,  ///< beta_T, 1, beta_T: unsymmetric tangent
    energy,      ///< beta_T, 1/beta_T, 1: from a potential
    proportional ///< beta_T, beta_T, beta_T^2: unsymmetric tangent
  };

  /// Effective gap sqrt(<g_N>^2 + b^2 |g_T|^2), traction
  /// k (<g_N> n + a g_T). Both dimensionless.
  struct ModeFactors
  {
    double a = 1.;
    double b = 1.;
  };

  /// The word in the prm file, such as "slip limit"; anything else throws
  /// ExcParameter.
  ModeMixing mode_mixing(const std::string &name);

  /// @p coupling is beta_T [-], peak shear over peak tension.
  ModeFactors mode_factors(const ModeMixing mixing, const double coupling);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// The tangential gap of a point under pressure: bond, friction, augmentation.
#ifndef demold_adhesion_sliding_gap_h
#define demold_adhesion_sliding_gap_h

#include "adhesion/mode_mixing.h"
#include "adhesion/radial_gap.h"

#include <deal.II/base/tensor.h>

namespace demold
{
  /// What the tangential rows of theory C.4 have in common.
  struct PressedPoint
  {
    dealii::Tensor<1, 3> traction; ///< lambda_hat_T [MPa]
    double               limit;    ///< L = mu omega p [MPa]
    dealii::Tensor<1, 3> start;    ///< g_T^n [mm]
    ModeFactors          factors;
    double               c; ///< c_N [MPa/mm]
  };

  /// A tangential gap and its derivatives.
  struct TangentialGap
  {
    dealii::Tensor<1, 3> gap;         ///< g_T [mm]
    dealii::Tensor<2, 3> by_traction; ///< dg_T/dlambda_hat_T [mm/MPa]
    dealii::Tensor<1, 3> by_limit;    ///< dg_T/dL [mm/MPa]
    dealii::Tensor<2, 3> by_start;    ///< dg_T/dg_T^n [-]
    /// Unit direction of sliding; 0 in stick.
    dealii::Tensor<1, 3> direction;
    bool                 slides = false;
    /// Part of the limit of friction in use [-].
    double used = 1.;
    /// Effective gap [mm] if softening: negative below the strength.
    double effective = 0.;
  };

  /// g_T = g_T^n.
  TangentialGap stuck(const PressedPoint &p);

  /// A bond of @p stiffness k [MPa/mm], friction and the augmentation:
  /// a (k + c) g_T + L d/|d| = lambda_hat_T with d = g_T - g_T^n, or stick.
  TangentialGap slide(const PressedPoint &p, const double stiffness);

  enum class SlideAxis
  {
    traction, ///< that of an intact bond
    start     ///< predictor of a damaged one, theory D.2
  };

  /// Softening along the unit vector e of lambda_hat_T or g_T^n, whether the
  /// limit is reached or not: a/b s(b x) + a c x + L = lambda_hat_T . e, and
  /// g_T = x e.
  TangentialGap radial_slide(const PressedPoint   &p,
                             const PointSoftening &softening,
                             const SlideAxis       axis);

  /// Softening against friction, a/b s(b |g_T|) g_T/|g_T| + a c g_T + L d/|d|
  /// = lambda_hat_T, for a point whose slide with the secant stiffness of
  /// @p kappa_old [mm] exceeds kappa_old. Not cut at rupture.
  TangentialGap softening_slide(const PressedPoint   &p,
                                const PointSoftening &softening,
                                const double          kappa_old);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// What a bond loses along a straight path of its gap when modes are mixed.
#ifndef demold_adhesion_gap_path_h
#define demold_adhesion_gap_path_h

#include "adhesion/mode_mixing.h"
#include "adhesion/softening.h"

#include <deal.II/base/tensor.h>

namespace demold
{
  /// The gap of one increment, straight from start to end [mm], seen with one
  /// unit normal.
  struct GapPath
  {
    dealii::Tensor<1, 3> start;
    dealii::Tensor<1, 3> end;
    dealii::Tensor<1, 3> normal;
    ModeFactors          factors;

    /// Effective gap squared [mm^2] at @p fraction (0 start, 1 end).
    double effective_squared(const double fraction) const;
    /// d(effective gap squared)/d(fraction) [mm^2].
    double effective_squared_rate(const double fraction) const;
    /// Half of its second derivative [mm^2], constant while g_N keeps its sign.
    double curvature(const double fraction) const;
    /// rho = (<g_N>^2 + a |g_T|^2)/effective gap^2 [-], 1 where a = b^2.
    double mode_ratio(const double fraction) const;
    /// Fraction from which on the effective gap exceeds @p kappa [mm]: there
    /// is one such point, the effective gap being convex along the path.
    double reaches(const double kappa) const;
  };

  /// Integral of -k'(kappa)/2 (<g_N>^2 + a |g_T|^2) dkappa = integral of
  /// rho dD(kappa) over the loading part of the path [mJ/mm^2], theory C.2:
  /// rho(end) Delta D by closed form, exact on proportional paths, and
  /// integral of (rho - rho(end)) dD by Gauss quadrature that follows the
  /// modes as they turn where the gap is least. With it
  /// integral of t.dg = Delta stored + dissipated along the path for every
  /// mixing. @p kappa_old [mm] is the gap from which on the bond is loaded,
  /// @p lost Delta D [mJ/mm^2], with what is lost at rupture.
  double decohesion_work(const GapPath   &path,
                         const Softening &softening,
                         const double     kappa_old,
                         const double     lost);
} // namespace demold

#endif

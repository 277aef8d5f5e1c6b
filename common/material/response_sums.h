// SPDX-License-Identifier: LGPL-2.1-or-later
// What a rubber law's summands add to: one stress, one tangent by its parts.
#ifndef demold_material_response_sums_h
#define demold_material_response_sums_h

#include "material/symmetric_six.h"

namespace demold
{
  /// A deformation as the laws need it. With A = C - 1 every small quantity is
  /// computed without cancellation.
  struct Deformation
  {
    /// @p C must have a positive determinant.
    explicit Deformation(const Six &C);

    Six    C;         ///< right Cauchy-Green tensor [-]
    Six    K;         ///< C^-1
    double I1_excess; ///< I1 - 3
    double I2_excess; ///< I2 - 3
    double JJ_excess; ///< J^2 - 1
    double J;         ///< det F
    double log_JJ;    ///< 2 ln J
    double p_excess;  ///< J^(-2/3) - 1
    double p;         ///< J^(-2/3)
  };

  /// The sum over the elastic law and the Maxwell branches.
  ///
  /// Every summand's tangent has the form
  ///   one (1x1 - I) + KK KxK + K_square K(.)K + UxK + KxU + rest,
  /// where (X(.)X)_ijkl = (X_ik X_jl + X_il X_jk)/2, so that summands add
  /// scalars and one vector; only `rest` is added entry by entry.
  struct ResponseSums
  {
    Six    S{{}};           ///< second Piola-Kirchhoff stress [MPa]
    double stored     = 0.; ///< [mJ/mm^3]
    double dissipated = 0.; ///< increment over the step [mJ/mm^3]

    double one      = 0.; ///< all tangent parts [MPa]
    double KK       = 0.;
    double K_square = 0.;
    Six    U{{}};
    double rest[6][6] = {}; ///< upper triangle only

    /// rest += product GxG + square G(.)G
    void add_rest(const Six &G, const double product, const double square);

    /// Writes the symmetric 6 x 6 matrix of the tangent, row by row; rows and
    /// columns in the order of Six.
    void write_tangent(const Six &K, double *tangent) const;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// The law of a cord-rubber ply at finite strain: rubber with families of cords.
#ifndef demold_material_belt_ply_h
#define demold_material_belt_ply_h

#include "material/elastic_laws.h"

#include <array>
#include <vector>

namespace demold
{
  /// Parallel cords, smeared over the ply (theory A.5). With the stretch of the
  /// cords lambda = (a0 . C a0)^(1/2),
  ///   W = 1/2 k (lambda - 1)^2,   k = E_c V_c.
  /// In compression (lambda < 1), where cords buckle, k is multiplied by
  /// `compression`; stress and energy stay continuous, the tangent jumps.
  struct FibreFamily
  {
    std::array<double, 3> direction   = {{1., 0., 0.}}; ///< a0, unit length
    double                stiffness   = 0.;             ///< k [MPa]
    double                compression = .01;            ///< [-]

    /// Adds stress [MPa], stored energy [mJ/mm^3] and, on demand, tangent.
    void add(const Deformation &x, bool with_tangent, ResponseSums &sums) const;
  };

  /// A ply: rubber whose shear modulus is that of the ply, G12, and its cords.
  /// The third of the elastic laws that a RubberLaw may have.
  struct BeltPly
  {
    static constexpr const char *name = "belt ply";

    MooneyRivlin             matrix;
    std::vector<FibreFamily> fibres;

    /// Of the matrix, at small strain [MPa].
    double shear_modulus() const
    {
      return matrix.shear_modulus();
    }

    double share_of_I2() const
    {
      return matrix.share_of_I2();
    }

    /// Of the matrix, at small strain [MPa].
    double bulk_modulus() const
    {
      return matrix.bulk_modulus();
    }

    /// Adds stress [MPa], stored energy [mJ/mm^3] and, on demand, tangent.
    void add(const Deformation &x, bool with_tangent, ResponseSums &sums) const;
  };
} // namespace demold

#endif

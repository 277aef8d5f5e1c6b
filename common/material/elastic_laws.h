// SPDX-License-Identifier: LGPL-2.1-or-later
// The two elastic laws of rubber, each the derivative of a stored energy.
#ifndef demold_material_elastic_laws_h
#define demold_material_elastic_laws_h

#include "material/response_sums.h"

namespace demold
{
  /// Compressible Mooney-Rivlin rubber (theory A1 to A4):
  ///   W = mu1/2 (I1-3) + mu2/2 (I2-3) + lambda/4 (J^2-1)
  ///       - (lambda/2 + mu1 + 2 mu2) ln J.
  /// The first Lame constant at small strain is lambda + 2 mu2.
  struct MooneyRivlin
  {
    static constexpr const char *name = "mooney-rivlin";

    double lambda = 50.; ///< [MPa]
    double mu1    = 0.4; ///< [MPa]
    double mu2    = 0.1; ///< [MPa]

    /// At small strain [MPa].
    double shear_modulus() const
    {
      return mu1 + mu2;
    }

    /// mu2/(mu1 + mu2), of a law without moduli 0 [-].
    double share_of_I2() const
    {
      return mu2 > 0. ? mu2 / (mu1 + mu2) : 0.;
    }

    /// At small strain [MPa].
    double bulk_modulus() const
    {
      return lambda + 2. * mu2 + 2. / 3. * (mu1 + mu2);
    }

    /// Adds stress [MPa], stored energy [mJ/mm^3] and, on demand, tangent.
    void add(const Deformation &x, bool with_tangent, ResponseSums &sums) const;
  };

  /// Mooney-Rivlin rubber in isochoric invariants (theory A.1, the form of
  /// Abaqus and CalculiX), I1bar = J^(-2/3) I1, I2bar = J^(-4/3) I2:
  ///   W = C10 (I1bar-3) + C01 (I2bar-3) + K/2 (J-1)^2.
  struct IsochoricMooneyRivlin
  {
    static constexpr const char *name = "mooney-rivlin isochoric";

    double C10  = 0.2;     ///< [MPa]
    double C01  = 0.05;    ///< [MPa]
    double bulk = 50.5333; ///< K [MPa]

    /// At small strain [MPa].
    double shear_modulus() const
    {
      return 2. * (C10 + C01);
    }

    /// C01/(C10 + C01), of a law without moduli 0 [-].
    double share_of_I2() const
    {
      return C01 > 0. ? C01 / (C10 + C01) : 0.;
    }

    /// At small strain [MPa].
    double bulk_modulus() const
    {
      return bulk;
    }

    /// Adds stress [MPa], stored energy [mJ/mm^3] and, on demand, tangent.
    void add(const Deformation &x, bool with_tangent, ResponseSums &sums) const;
  };
} // namespace demold

#endif

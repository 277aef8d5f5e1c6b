// SPDX-License-Identifier: LGPL-2.1-or-later
// The rules of mixture and the rotation of a ply.
#include "material/ply_constants.h"

#include <cmath>

namespace demold
{
  namespace
  {
    /// Between the moduli of rubber and cord (Halpin-Tsai, theory A.5).
    double halpin_tsai(const double rubber,
                       const double cord,
                       const double zeta,
                       const double V)
    {
      const double ratio = cord / rubber;
      const double eta   = (ratio - 1.) / (ratio + zeta);
      return rubber * (1. + zeta * eta * V) / (1. - eta * V);
    }

    LaminateConstants constants_of(const double A11,
                                   const double A22,
                                   const double A12,
                                   const double A66)
    {
      return {A11 - A12 * A12 / A22, A22 - A12 * A12 / A11, A66, A12 / A22};
    }
  } // namespace

  double CordRubber::cord_shear_modulus() const
  {
    return .5 * cord_modulus / (1. + cord_poisson);
  }

  double CordRubber::rubber_shear_modulus() const
  {
    return .5 * rubber_modulus / (1. + rubber_poisson);
  }

  const char *name_of(const PlyRule rule)
  {
    return rule == PlyRule::halpin_tsai    ? "halpin-tsai" :
           rule == PlyRule::gough_tangorra ? "gough-tangorra" :
                                             "akasaka-hirano";
  }

  PlyConstants ply_constants(const PlyRule rule, const CordRubber &parts)
  {
    const double V   = parts.volume_fraction;
    const double E_c = parts.cord_modulus, E_r = parts.rubber_modulus;
    const double E1 = E_c * V + E_r * (1. - V);
    switch (rule)
      {
        case PlyRule::halpin_tsai:
          return {E1,
                  halpin_tsai(E_r, E_c, 2., V),
                  halpin_tsai(parts.rubber_shear_modulus(),
                              parts.cord_shear_modulus(),
                              1.,
                              V),
                  parts.cord_poisson * V + parts.rubber_poisson * (1. - V)};
        case PlyRule::gough_tangorra:
          return {E1,
                  4. * E_r * (1. - V) * E1 /
                    (3. * E_c * V + 4. * E_r * (1. - V)),
                  parts.rubber_shear_modulus() * (1. - V),
                  .5};
        case PlyRule::akasaka_hirano:
          break;
      }
    return {E_c * V, 4. * E_r / 3., E_r / 3., .5};
  }

  PlaneStiffness off_axis(const PlyConstants &ply, const double angle)
  {
    const double nu21 = ply.E1 > 0. ? ply.nu12 * ply.E2 / ply.E1 : 0.;
    const double f    = 1. / (1. - ply.nu12 * nu21);
    const double Q11 = f * ply.E1, Q22 = f * ply.E2, Q66 = ply.G12;
    const double Q12 = f * ply.nu12 * ply.E2;
    const double c = std::cos(angle), s = std::sin(angle);
    const double cc = c * c, ss = s * s, sc = s * c;
    const double mixed = Q12 + 2. * Q66;
    return {Q11 * cc * cc + 2. * mixed * ss * cc + Q22 * ss * ss,
            Q11 * ss * ss + 2. * mixed * ss * cc + Q22 * cc * cc,
            (Q11 + Q22 - 4. * Q66) * ss * cc + Q12 * (cc * cc + ss * ss),
            sc * (Q11 * cc - Q22 * ss - mixed * (cc - ss)),
            sc * (Q11 * ss - Q22 * cc + mixed * (cc - ss)),
            (Q11 + Q22 - 2. * Q12) * ss * cc + Q66 * (cc - ss) * (cc - ss)};
  }

  LaminateConstants balanced_pair(const PlyConstants &ply, const double angle)
  {
    // Q16 and Q26 of the two plies cancel.
    const PlaneStiffness Q = off_axis(ply, angle);
    return constants_of(Q.Q11, Q.Q22, Q.Q12, Q.Q66);
  }

  LaminateConstants akasaka_pair(const CordRubber &parts, const double angle)
  {
    const double k = parts.cord_modulus * parts.volume_fraction;
    const double G = parts.rubber_shear_modulus();
    const double c = std::cos(angle), s = std::sin(angle);
    return constants_of(k * c * c * c * c + 4. * G,
                        k * s * s * s * s + 4. * G,
                        k * s * s * c * c + 2. * G,
                        k * s * s * c * c + G);
  }
} // namespace demold

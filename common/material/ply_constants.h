// SPDX-License-Identifier: LGPL-2.1-or-later
// Elastic constants of a cord-rubber ply and of a pair of plies at +-theta.
#ifndef demold_material_ply_constants_h
#define demold_material_ply_constants_h

namespace demold
{
  /// What a ply is made of (theory A.5).
  struct CordRubber
  {
    double cord_modulus    = 172200.; ///< E_c [MPa]
    double cord_poisson    = .3;      ///< nu_c [-]
    double rubber_modulus  = 6.;      ///< E_r [MPa]
    double rubber_poisson  = .49;     ///< nu_r [-]
    double volume_fraction = .15;     ///< V_c of the cords [-], in [0, 1)

    double cord_shear_modulus() const;   ///< G_c [MPa]
    double rubber_shear_modulus() const; ///< G_r [MPa]
  };

  /// How the constants of a ply follow from those of its parts.
  enum class PlyRule
  {
    halpin_tsai,    ///< Halpin and Tsai; zeta = 2 for E2, 1 for G12
    gough_tangorra, ///< Gough and Tangorra
    akasaka_hirano  ///< Akasaka and Hirano: inextensible cords
  };

  /// "halpin-tsai", "gough-tangorra", "akasaka-hirano".
  const char *name_of(PlyRule rule);

  /// Constants of one ply at small strain in plane stress; direction 1 is that
  /// of the cords.
  struct PlyConstants
  {
    double E1;   ///< [MPa]
    double E2;   ///< [MPa]
    double G12;  ///< [MPa]
    double nu12; ///< [-]
  };

  /// Theory A.5.
  PlyConstants ply_constants(PlyRule rule, const CordRubber &parts);

  /// Plane-stress stiffness in axes x, y: s_xx = Q11 e_xx + Q12 e_yy + Q16 g_xy
  /// and so on, with the engineering shear strain g_xy [MPa].
  struct PlaneStiffness
  {
    double Q11, Q22, Q12, Q16, Q26, Q66;
  };

  /// Qbar = T^-1 Q T^-T of a ply whose cords stand at @p angle [rad] to x.
  PlaneStiffness off_axis(const PlyConstants &ply, double angle);

  /// Constants of a laminate in its axes x, y.
  struct LaminateConstants
  {
    double E_x;   ///< [MPa]
    double E_y;   ///< [MPa]
    double G_xy;  ///< [MPa]
    double nu_xy; ///< - e_yy/e_xx in tension along x [-]
  };

  /// Two plies at +@p angle and -@p angle [rad] to x, of equal thickness and
  /// bonded so that they cannot shear one over the other.
  LaminateConstants balanced_pair(const PlyConstants &ply, double angle);

  /// The same in closed form for inextensible cords in incompressible rubber of
  /// the shear modulus G_r (Akasaka; theory A.5):
  ///   E_x = E_c V_c c^4 + 4 G_r
  ///         - (E_c V_c s^2 c^2 + 2 G_r)^2 / (E_c V_c s^4 + 4 G_r).
  LaminateConstants akasaka_pair(const CordRubber &parts, double angle);
} // namespace demold

#endif

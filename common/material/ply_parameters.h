// SPDX-License-Identifier: LGPL-2.1-or-later
// A cord-rubber ply and a belt of plies as the prm file describes them.
#ifndef demold_material_ply_parameters_h
#define demold_material_ply_parameters_h

#include "material/belt_ply.h"
#include "material/ply_constants.h"
#include "material/rubber_law.h"

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// One ply by what a tire drawing says of it. The entries belong to the
  /// section that is open when they are added.
  struct PlyParameters
  {
    double cord_modulus   = 172200.; ///< E_c [MPa]
    double cord_poisson   = .3;      ///< nu_c [-]
    double cord_area      = .212;    ///< A_c of one cord's steel [mm^2]
    double cord_spacing   = 1.16;    ///< s between middles of cords [mm]
    double thickness      = 1.2;     ///< h [mm]
    double rubber_modulus = 6.;      ///< E_r [MPa]
    double rubber_poisson = .49;     ///< nu_r [-]

    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws ExcParameter where cords overlap; @p section is named in it.
    void check(const std::string &section) const;

    /// V_c = A_c/(s h) [-].
    double volume_fraction() const;

    CordRubber parts() const;
  };

  /// Section "Belt": plies behind a tread block, from the block outwards.
  struct BeltParameters
  {
    PlyParameters       ply;
    std::vector<double> angles      = {20., -20.};   ///< to the x axis [degree]
    std::string         rule        = "halpin-tsai"; ///< of G12
    double              compression = .01;           ///< see FibreFamily

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;

    /// The law of ply @p number in a body of dimension @p dim: the plies lie
    /// in the plane x, y of a 3-D body; of a 2-D slice, whose y is the
    /// thickness, in the plane of x and the direction out of the slice. The
    /// matrix has mu1 = G12 by the rule, mu2 = 0 and the first Lame constant of
    /// the rubber (theory A.5).
    RubberLaw law(unsigned int number, int dim) const;
  };
} // namespace demold

#endif

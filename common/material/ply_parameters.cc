// SPDX-License-Identifier: LGPL-2.1-or-later
// A cord-rubber ply and a belt of plies as the prm file describes them.
#include "material/ply_parameters.h"

#include "base/parameter_error.h"

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <cmath>
#include <sstream>

namespace demold
{
  using namespace dealii;

  void PlyParameters::add_parameters(ParameterHandler &prm)
  {
    const Patterns::Double positive(1e-6, 1e9), poisson(0., .4999);
    prm.add_parameter("cord modulus",
                      cord_modulus,
                      "E_c Young's modulus of a cord along itself [MPa]",
                      positive);
    prm.add_parameter("cord poisson ratio",
                      cord_poisson,
                      "nu_c of a cord [-]",
                      poisson);
    prm.add_parameter("cord area",
                      cord_area,
                      "A_c cross section of the steel of one cord [mm^2]",
                      positive);
    prm.add_parameter("cord spacing",
                      cord_spacing,
                      "s distance between the middles of cords [mm]",
                      positive);
    prm.add_parameter("ply thickness",
                      thickness,
                      "h of one ply with its rubber [mm]",
                      positive);
    prm.add_parameter("rubber modulus",
                      rubber_modulus,
                      "E_r Young's modulus of the rubber of the ply [MPa]",
                      positive);
    prm.add_parameter("rubber poisson ratio",
                      rubber_poisson,
                      "nu_r of the rubber of the ply [-]",
                      poisson);
  }

  void PlyParameters::check(const std::string &section) const
  {
    const double diameter = std::sqrt(4. * cord_area / numbers::PI);
    for (const auto &[entry, room] :
         {std::make_pair("cord spacing", cord_spacing),
          std::make_pair("ply thickness", thickness)})
      if (room < diameter)
        {
          std::ostringstream text;
          text << "must be at least the diameter of a cord of " << section
               << "/cord area = " << cord_area << " mm^2, that is " << diameter
               << " mm; got " << room << " mm. Raise it or take thinner cords.";
          throw ExcParameter(section + "/" + entry, text.str());
        }
    if (cord_modulus <= rubber_modulus)
      {
        std::ostringstream text;
        text << "must exceed " << section
             << "/rubber modulus = " << rubber_modulus << " MPa; got "
             << cord_modulus << " MPa. Cords carry the ply.";
        throw ExcParameter(section + "/cord modulus", text.str());
      }
  }

  double PlyParameters::volume_fraction() const
  {
    return cord_area / (cord_spacing * thickness);
  }

  CordRubber PlyParameters::parts() const
  {
    return {cord_modulus,
            cord_poisson,
            rubber_modulus,
            rubber_poisson,
            volume_fraction()};
  }

  void BeltParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Belt");
    ply.add_parameters(prm);
    prm.add_parameter("angles",
                      angles,
                      "theta of the cords to the x axis, a ply each, from the "
                      "block outwards [degree]",
                      Patterns::List(Patterns::Double(-90., 90.), 1, 10));
    prm.add_parameter("rule",
                      rule,
                      "how the shear modulus G12 of a ply follows from cord "
                      "and rubber",
                      Patterns::Selection(
                        "halpin-tsai|gough-tangorra|akasaka-hirano"));
    prm.add_parameter("compression factor",
                      compression,
                      "stiffness of cords in compression over that in tension "
                      "[-]",
                      Patterns::Double(0., 1.));
    prm.leave_subsection();
  }

  void BeltParameters::check() const
  {
    ply.check("Belt");
  }

  RubberLaw BeltParameters::law(const unsigned int number, const int dim) const
  {
    const CordRubber parts = ply.parts();
    const double     E = parts.rubber_modulus, nu = parts.rubber_poisson;
    const double     angle = angles.at(number) * numbers::PI / 180.;
    const double     c = std::cos(angle), s = std::sin(angle);

    PlyRule chosen = PlyRule::halpin_tsai;
    for (const PlyRule other :
         {PlyRule::gough_tangorra, PlyRule::akasaka_hirano})
      if (rule == name_of(other))
        chosen = other;

    BeltPly elastic;
    elastic.matrix.mu1    = ply_constants(chosen, parts).G12;
    elastic.matrix.mu2    = 0.;
    elastic.matrix.lambda = E * nu / ((1. + nu) * (1. - 2. * nu));

    FibreFamily cords;
    cords.direction   = {{c, dim == 3 ? s : 0., dim == 3 ? 0. : s}};
    cords.stiffness   = parts.cord_modulus * parts.volume_fraction;
    cords.compression = compression;
    elastic.fibres    = {cords};

    RubberLaw law;
    law.elastic = elastic;
    return law;
  }
} // namespace demold

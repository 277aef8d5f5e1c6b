// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Press of a parameter file: heating in the mould, opening, cooling.
#include "cure/press_parameters.h"

#include "base/parameter_error.h"

#include <deal.II/base/parameter_handler.h>

#include <sstream>

namespace demold
{
  using namespace dealii;

  void PressParameters::Side::add_parameters(ParameterHandler  &prm,
                                             const std::string &name)
  {
    prm.enter_subsection(name);
    prm.add_parameter("contact",
                      contact,
                      "thermal contact while the press is closed: the same "
                      "temperature, a film, or no heat flux",
                      Patterns::Selection("perfect|film|insulated"));
    prm.add_parameter("temperature",
                      temperature,
                      "T over time: a number, a table \"time: temperature, "
                      "...\" or a formula in t [s] [degC]");
    prm.add_parameter("film coefficient",
                      film_coefficient,
                      "h heat flux per temperature difference; 0.001 is 1 "
                      "W/(m2 K) [N/(mm s K)]",
                      Patterns::Double(0.));
    prm.leave_subsection();
  }



  ThermalSide PressParameters::Side::side(const std::string &name) const
  {
    ThermalSide side;
    side.contact = contact == "perfect" ? ThermalSide::perfect :
                   contact == "film"    ? ThermalSide::film :
                                          ThermalSide::insulated;
    side.temperature =
      TemperatureHistory::parse(temperature, "Press/" + name + "/temperature");
    side.film_coefficient = film_coefficient;
    return side;
  }



  void PressParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Press");
    prm.add_parameter("conductivity",
                      conductivity,
                      "k of the rubber, the number in W/(m K) [N/(s K)]",
                      Patterns::Double(1e-9));
    prm.add_parameter("heat capacity",
                      heat_capacity,
                      "rho c_p of the rubber, the number in MJ/(m3 K) [MPa/K]",
                      Patterns::Double(1e-9));
    prm.add_parameter("initial temperature",
                      initial_temperature,
                      "T of the block when the press closes [degC]",
                      Patterns::Double(-273.));
    mould.add_parameters(prm, "Mould side");
    bladder.add_parameters(prm, "Bladder side");
    prm.add_parameter("opening time",
                      opening_time,
                      "t at which the press opens [s]",
                      Patterns::Double(1e-6));
    prm.add_parameter("end time",
                      end_time,
                      "t at which cooling in air is followed no further [s]",
                      Patterns::Double(1e-6));
    prm.add_parameter("air temperature",
                      air,
                      "T of the air over time, as for the sides [degC]");
    prm.add_parameter("air film coefficient",
                      air_film,
                      "h between rubber and air, free convection 0.005 to "
                      "0.025 [N/(mm s K)]",
                      Patterns::Double(0.));
    prm.add_parameter("tolerance",
                      tolerance,
                      "relative error of the temperature in a step [-]",
                      Patterns::Double(1e-12, 1e-2));
    prm.leave_subsection();
  }



  void PressParameters::check() const
  {
    cycle();
    if (end_time < opening_time)
      {
        std::ostringstream text;
        text << "must not lie before Press/opening time = " << opening_time
             << " s; got " << end_time
             << " s. Take the same value to leave out the cooling.";
        throw ExcParameter("Press/end time", text.str());
      }
    if (mould.contact == "insulated" && bladder.contact == "insulated")
      throw ExcParameter("Press/Mould side/contact",
                         "must not be insulated when the bladder side is; got "
                         "insulated for both. Something has to heat the "
                         "block.");
  }



  PressCycle PressParameters::cycle() const
  {
    PressCycle cycle;
    cycle.material            = {conductivity, heat_capacity};
    cycle.initial_temperature = initial_temperature;
    cycle.mould               = mould.side("Mould side");
    cycle.bladder             = bladder.side("Bladder side");
    cycle.opening_time        = opening_time;
    cycle.end_time            = end_time;
    cycle.air.contact         = ThermalSide::film;
    cycle.air.temperature =
      TemperatureHistory::parse(air, "Press/air temperature");
    cycle.air.film_coefficient = air_film;
    cycle.tolerances           = {tolerance, 1e3 * tolerance};
    return cycle;
  }
} // namespace demold

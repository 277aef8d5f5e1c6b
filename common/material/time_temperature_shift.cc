// SPDX-License-Identifier: LGPL-2.1-or-later
// The laws of Williams, Landel and Ferry and of Arrhenius, and their limits.
#include "material/time_temperature_shift.h"

#include "base/parameter_error.h"

#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr double absolute_zero = -273.15;             // [degC]
    constexpr double gas_constant  = 8.31446261815324e-3; // [kJ/(mol K)]

    template <typename... Pieces>
    [[noreturn]] void reject(const std::string &entry, const Pieces &...pieces)
    {
      std::ostringstream text;
      (text << ... << pieces);
      throw ExcParameter("Material/" + entry, text.str());
    }
  } // namespace

  void TimeTemperatureShift::add_parameters(ParameterHandler &prm)
  {
    const Patterns::Double degrees(-273., 2000.);

    prm.add_parameter("time-temperature shift",
                      kind,
                      "law of a_T in tau_j(T) = a_T tau_j(T_ref) [-]",
                      Patterns::Selection("none|WLF|Arrhenius"));
    prm.add_parameter("temperature",
                      temperature,
                      "T of the rubber; matters with a shift only [degC]",
                      degrees);
    prm.add_parameter("reference temperature",
                      reference,
                      "T_ref at which the relaxation times hold [degC]",
                      degrees);
    prm.add_parameter("c1",
                      c1,
                      "c1 of WLF, log10 a_T = -c1 (T - T_ref)/(c2 + T - T_ref) "
                      "[-]");
    prm.add_parameter("c2", c2, "c2 of WLF [degC]");
    prm.add_parameter("activation energy",
                      activation_energy,
                      "E_a of Arrhenius, ln a_T = E_a/R (1/T - 1/T_ref) "
                      "[kJ/mol]");
  }

  void TimeTemperatureShift::check() const
  {
    if (kind == "none")
      return;
    if (kind == "Arrhenius" && !(activation_energy > 0.))
      reject("activation energy",
             "must be greater than 0 kJ/mol with the time-temperature shift "
             "Arrhenius; got ",
             activation_energy,
             '.');
    if (kind == "WLF")
      {
        if (!(c1 > 0.))
          reject("c1",
                 "must be greater than 0; got ",
                 c1,
                 ". Some sources write log10 a_T = +c1 (T - T_ref)/(...): "
                 "change the sign of theirs.");
        if (!(c2 > 0.))
          reject("c2", "must be greater than 0 degC; got ", c2, '.');
        if (!(c2 + temperature - reference > 0.))
          reject("temperature",
                 "must exceed reference temperature - c2 = ",
                 reference - c2,
                 " degC, where WLF has its pole; got ",
                 temperature,
                 " degC. The rubber is a glass there.");
      }
    constexpr double limit  = 1e100;
    const double     factor = this->factor();
    if (!(factor > 1. / limit && factor < limit))
      reject("temperature",
             "must shift the relaxation times by less than 100 decades; got a "
             "factor of ",
             factor,
             " at ",
             temperature,
             " degC. Move it towards the reference temperature of ",
             reference,
             " degC.");
  }

  double TimeTemperatureShift::factor(const double T) const
  {
    const double above = T - reference;
    if (kind == "WLF")
      return std::pow(10., -c1 * above / (c2 + above));
    if (kind == "Arrhenius")
      return std::exp(-activation_energy / gas_constant * above /
                      ((T - absolute_zero) * (reference - absolute_zero)));
    return 1.;
  }
} // namespace demold

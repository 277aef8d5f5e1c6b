// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Cure of a parameter file: how the compound cures.
#include "cure/cure_parameters.h"

#include "base/parameter_error.h"

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace demold
{
  using namespace dealii;

  namespace
  {
    const char *const energy_help = "E its activation energy [kJ/mol]";
  }

  CureParameters::CureParameters()
    : conversion_f90(default_conversion().f90)
    , conversion_degree(default_conversion().degree)
  {}



  void CureParameters::Rate::add_parameters(ParameterHandler  &prm,
                                            const std::string &name,
                                            const std::string &symbol)
  {
    prm.add_parameter(name,
                      value,
                      symbol + " at the reference temperature [1/s]",
                      Patterns::Double(0.));
    prm.add_parameter(name + " energy",
                      energy,
                      energy_help,
                      Patterns::Double(0.));
  }



  void CureParameters::Wait::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("induction time",
                      time,
                      "t_i at the reference temperature, before which nothing "
                      "cures; 0: none [s]",
                      Patterns::Double(0.));
    prm.add_parameter("induction energy",
                      energy,
                      energy_help,
                      Patterns::Double(0.));
  }



  void CureParameters::add_laws(ParameterHandler &prm)
  {
    prm.enter_subsection("Kamal-Sourour");
    kamal_sourour.k1.add_parameters(prm, "k1", "k1 of the start");
    kamal_sourour.k2.add_parameters(prm, "k2", "k2 of the growth");
    prm.add_parameter("m",
                      kamal_sourour.m,
                      "m exponent of alpha [-]",
                      Patterns::Double(0.));
    prm.add_parameter("n",
                      kamal_sourour.n,
                      "n exponent of 1 - alpha [-]",
                      Patterns::Double(0.));
    kamal_sourour.wait.add_parameters(prm);
    prm.leave_subsection();

    prm.enter_subsection("Isayev-Deng");
    isayev_deng.k.add_parameters(prm, "k", "k rate");
    prm.add_parameter("n",
                      isayev_deng.n,
                      "n exponent [-]",
                      Patterns::Double(1.));
    isayev_deng.wait.add_parameters(prm);
    prm.leave_subsection();

    prm.enter_subsection("Han");
    han.k1.add_parameters(prm, "k1", "k1 of stable crosslinks");
    han.k2.add_parameters(prm, "k2", "k2 of unstable crosslinks");
    han.k3.add_parameters(prm, "k3", "k3 of the loss of unstable crosslinks");
    han.wait.add_parameters(prm);
    prm.leave_subsection();
  }



  void CureParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Cure");
    prm.add_parameter("reference temperature",
                      reference_temperature,
                      "T_ref of t90 and of all rates [degC]",
                      Patterns::Double(-273.));
    prm.add_parameter("t90",
                      t90,
                      "t90 at the reference temperature [s]",
                      Patterns::Double(1e-6));
    prm.add_parameter("activation energy",
                      activation_energy,
                      "E_a of the equivalent time and of t90 [kJ/mol]",
                      Patterns::Double(0.));
    prm.add_parameter("kinetics",
                      kinetics,
                      "law of the degree of cure alpha; equivalent time: alpha "
                      "by the table over f90",
                      Patterns::Selection("equivalent time|kamal-sourour|"
                                          "isayev-deng|han"));
    const Patterns::List numbers(Patterns::Double(0.));
    prm.add_parameter("conversion f90",
                      conversion_f90,
                      "f90 of the table alpha(f90) [-]",
                      numbers);
    prm.add_parameter("conversion degree",
                      conversion_degree,
                      "alpha of the table alpha(f90) [-]",
                      numbers);
    prm.add_parameter("tolerance",
                      tolerance,
                      "relative error of an integration step [-]",
                      Patterns::Double(1e-13, 1e-2));
    add_laws(prm);
    prm.leave_subsection();
  }



  void CureParameters::check() const
  {
    const std::string why_not =
      MonotoneTable::problem(conversion_f90, conversion_degree);
    if (!why_not.empty())
      throw ExcParameter("Cure/conversion f90", why_not);
    const double top =
      *std::max_element(conversion_degree.begin(), conversion_degree.end());
    if (top > 1.)
      throw ExcParameter("Cure/conversion degree",
                         "must not exceed 1; got " + std::to_string(top) +
                           ". A degree of cure is a share.");
  }



  ArrheniusRate CureParameters::rate(const Rate &entry) const
  {
    return {entry.value, entry.energy, reference_temperature};
  }

  ArrheniusTime CureParameters::wait(const Wait &entry) const
  {
    return {entry.time, entry.energy, reference_temperature};
  }



  CureModel CureParameters::model() const
  {
    CureModel model;
    model.t90        = {t90, activation_energy, reference_temperature};
    model.conversion = MonotoneTable(conversion_f90, conversion_degree);
    if (kinetics == "kamal-sourour")
      model.kinetics = Kinetics{KamalSourour{rate(kamal_sourour.k1),
                                             rate(kamal_sourour.k2),
                                             kamal_sourour.m,
                                             kamal_sourour.n},
                                wait(kamal_sourour.wait)};
    else if (kinetics == "isayev-deng")
      model.kinetics = Kinetics{IsayevDeng{rate(isayev_deng.k), isayev_deng.n},
                                wait(isayev_deng.wait)};
    else if (kinetics == "han")
      model.kinetics =
        Kinetics{Han{rate(han.k1), rate(han.k2), rate(han.k3)}, wait(han.wait)};
    return model;
  }



  OdeTolerances CureParameters::tolerances() const
  {
    return {tolerance, 1e-2 * tolerance};
  }
} // namespace demold

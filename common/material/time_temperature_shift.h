// SPDX-License-Identifier: LGPL-2.1-or-later
// How the temperature stretches or shortens all relaxation times.
#ifndef demold_material_time_temperature_shift_h
#define demold_material_time_temperature_shift_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// The shift factor a_T of a thermorheologically simple rubber,
  /// tau_j(T) = a_T tau_j(T_ref) (theory A.2):
  ///   WLF        log10 a_T = -c1 (T - T_ref)/(c2 + T - T_ref)
  ///   Arrhenius  ln a_T = E_a/R (1/T - 1/T_ref), both T absolute.
  /// The moduli do not depend on temperature. The default c1, c2 and T_ref are
  /// those of a tread rubber (Sci. Rep. 2021, s41598-021-97921-0, figure 1).
  struct TimeTemperatureShift
  {
    std::string kind = "none"; ///< none, WLF or Arrhenius

    double temperature       = 70.;    ///< T [degC]
    double reference         = 70.;    ///< T_ref of the relaxation times [degC]
    double c1                = 4.41;   ///< [-]
    double c2                = 137.64; ///< [degC]
    double activation_energy = 0.;     ///< E_a [kJ/mol]

    /// Declares the entries in the current section.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws ExcParameter with the path `Material/...`.
    void check() const;

    /// a_T [-] at @p T [degC]; 1 where kind is `none`. Of WLF it means
    /// something above the pole T_ref - c2 only, where check() keeps T.
    double factor(double T) const;

    /// a_T [-] at the temperature of the entry.
    double factor() const
    {
      return factor(temperature);
    }
  };
} // namespace demold

#endif

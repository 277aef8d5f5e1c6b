// SPDX-License-Identifier: LGPL-2.1-or-later
// A rubber compound as the prm file describes it: the law at any cure.
#ifndef demold_material_rubber_model_h
#define demold_material_rubber_model_h

#include "material/rubber_law.h"
#include "material/time_temperature_shift.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Section `Material`. A compound of one state of cure is given by the
  /// constants; one whose cure varies by tables over the t90-factor f90
  /// (theory A.3), interpolated monotonically. The bulk response does not
  /// depend on cure (theory A.1).
  class RubberModel
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws ExcParameter for what cannot be simulated. To be called once all
    /// entries are parsed; prepares the tables that at() reads.
    void check() const;

    /// The law at the t90-factor @p f90 [-] and the temperature of the entry.
    /// Throws ExcParameter outside the
    /// table; a computed f90 is to be clamped to f90_range() by the caller.
    RubberLaw at(double f90) const;

    /// The same at @p temperature [degC] instead.
    RubberLaw at(double f90, double temperature) const;

    /// The entry `temperature` [degC].
    double temperature() const
    {
      return shift.temperature;
    }

    /// Do the relaxation times depend on temperature?
    bool shifts_with_temperature() const
    {
      return shift.kind != "none";
    }

    /// The f90 between which at() answers [-]; without tables any.
    std::pair<double, double> f90_range() const;

    /// Is the entry `f90` one number, as opposed to an expression in x, y, z?
    bool f90_is_uniform() const;

    /// That number [-]; throws ExcParameter where there is an expression.
    double uniform_f90() const;

    /// The entry `f90` as written: a number or an expression in the reference
    /// coordinates x, y, z [mm].
    const std::string &f90_expression() const
    {
      return f90;
    }

    bool has_tables() const
    {
      return !table_f90.empty();
    }

    /// Maxwell branches of the law; none without viscosity.
    unsigned int n_branches() const
    {
      return viscosity ? relaxation_times.size() : 0;
    }

    double density = 1.12e-9; ///< rho [t/mm^3]

  private:
    struct Tables;

    void add_elastic_parameters(dealii::ParameterHandler &prm);
    void add_viscous_parameters(dealii::ParameterHandler &prm);
    void add_cure_parameters(dealii::ParameterHandler &prm);

    void check_constants() const;
    void check_viscosity() const;
    void check_tables() const;
    void check_f90() const;

    RubberLaw law_of_constants() const;
    RubberLaw law_of_moduli(double equilibrium) const;

    std::string           model = MooneyRivlin::name;
    MooneyRivlin          mooney_rivlin;
    IsochoricMooneyRivlin isochoric;

    bool                viscosity = true;
    std::vector<double> relaxation_times; // [s]
    std::vector<double> branch_moduli;    // E_j [MPa]
    std::string         branch_law = "isochoric neo-hooke";
    std::string         update     = "EXP2";

    TimeTemperatureShift shift;

    std::string                      f90 = "1.0";
    std::vector<double>              table_f90;
    std::vector<double>              table_equilibrium; // E_inf [MPa]
    double                           table_mu2_over_mu1 = 0.25;
    std::vector<std::vector<double>> table_branch_moduli; // E_j [MPa]

    mutable std::shared_ptr<const Tables> tables;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// From the entries of section Material to the law at a degree of cure.
#include "material/rubber_model.h"

#include "base/monotone_table.h"
#include "base/parameter_error.h"

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace demold
{
  using namespace dealii;

  struct RubberModel::Tables
  {
    MonotoneTable              equilibrium; // E_inf [MPa] over f90
    std::vector<MonotoneTable> branches;    // E_j [MPa] over f90
  };

  namespace
  {
    ViscousUpdate update_by_name(const std::string &name)
    {
      return name == "BE"  ? ViscousUpdate::be :
             name == "LIN" ? ViscousUpdate::lin :
                             ViscousUpdate::exp2;
    }

    std::vector<double> column(const std::vector<std::vector<double>> &rows,
                               const unsigned int                      j)
    {
      std::vector<double> values;
      for (const std::vector<double> &row : rows)
        values.push_back(row[j]);
      return values;
    }

    /// Admissible levels alone do not tell: what is simulated is the curve.
    void require_between_levels(const MonotoneTable       &table,
                                const std::vector<double> &levels,
                                const double               lower_bound,
                                const std::string         &entry)
    {
      const unsigned int n_samples = 20;
      for (unsigned int i = 1; i < levels.size(); ++i)
        for (unsigned int k = 1; k < n_samples; ++k)
          {
            const double x =
              levels[i - 1] + k * (levels[i] - levels[i - 1]) / n_samples;
            if (!(table(x) >= lower_bound))
              {
                std::ostringstream text;
                text << "must not fall below 0 MPa between its levels; got "
                     << table(x) << " MPa at f90 = " << x
                     << ". Add a level there.";
                throw ExcParameter("Material/" + entry, text.str());
              }
          }
    }
  } // namespace

  void RubberModel::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Material");
    add_elastic_parameters(prm);
    add_viscous_parameters(prm);
    add_cure_parameters(prm);
    prm.leave_subsection();
  }

  void RubberModel::add_elastic_parameters(ParameterHandler &prm)
  {
    const Patterns::Double positive(0.);

    prm.add_parameter("model",
                      model,
                      "elastic law of the rubber [-]",
                      Patterns::Selection(std::string(MooneyRivlin::name) +
                                          "|" + IsochoricMooneyRivlin::name));
    prm.add_parameter("density",
                      density,
                      "rho mass per reference volume [t/mm^3]",
                      positive);

    prm.add_parameter("lambda",
                      mooney_rivlin.lambda,
                      "Lambda volumetric stiffness; mooney-rivlin [MPa]",
                      positive);
    prm.add_parameter("mu1",
                      mooney_rivlin.mu1,
                      "mu1 modulus of I1; mooney-rivlin [MPa]",
                      positive);
    prm.add_parameter("mu2",
                      mooney_rivlin.mu2,
                      "mu2 modulus of I2; mooney-rivlin [MPa]",
                      positive);
    prm.add_parameter("C10",
                      isochoric.C10,
                      "C10 modulus of I1bar; mooney-rivlin isochoric [MPa]",
                      positive);
    prm.add_parameter("C01",
                      isochoric.C01,
                      "C01 modulus of I2bar; mooney-rivlin isochoric [MPa]",
                      positive);
    prm.add_parameter("bulk modulus",
                      isochoric.bulk,
                      "K bulk modulus; mooney-rivlin isochoric [MPa]",
                      positive);
  }

  void RubberModel::add_viscous_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("viscosity",
                      viscosity,
                      "true: with the Maxwell branches below; false: without, "
                      "elastic; their entries are checked all the same [-]");
    prm.add_parameter("relaxation times",
                      relaxation_times,
                      "tau_j of the Maxwell branches; none: elastic [s]");
    prm.add_parameter("branch moduli",
                      branch_moduli,
                      "E_j = 3 mu_j, one for each relaxation time [MPa]");
    prm.add_parameter("branch law",
                      branch_law,
                      "what the branches are at finite strain [-]",
                      Patterns::Selection(branch_law_names));
    prm.add_parameter("update",
                      update,
                      "time integration of isochoric neo-hooke branches [-]: "
                      "EXP2 second order, BE backward Euler, LIN second order "
                      "at small strain only; the other branch laws have one of "
                      "their own, of second order",
                      Patterns::Selection("EXP2|BE|LIN"));
    shift.add_parameters(prm);
  }

  void RubberModel::add_cure_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("f90",
                      f90,
                      "f90 t90-factor, the degree of cure [-]: a number, or "
                      "an expression in the reference coordinates x, y, z "
                      "[mm]; matters with tables only");
    prm.add_parameter("table f90",
                      table_f90,
                      "f90 levels of the tables, increasing [-]; none: the "
                      "constants above hold for any f90");
    prm.add_parameter("table equilibrium modulus",
                      table_equilibrium,
                      "E_inf at each level [MPa]; mu1 + mu2, or 2 (C10 + C01), "
                      "is a third of it");
    prm.add_parameter("table mu2 over mu1",
                      table_mu2_over_mu1,
                      "mu2/mu1, or C01/C10, at every level [-]",
                      Patterns::Double(0.));
    prm.add_parameter("table branch moduli",
                      table_branch_moduli,
                      "E_j of all branches at each level [MPa]: one row for "
                      "each f90, rows separated by ';', numbers by ','");
  }

  RubberLaw RubberModel::law_of_constants() const
  {
    RubberLaw law;
    if (model == MooneyRivlin::name)
      law.elastic = mooney_rivlin;
    else
      law.elastic = isochoric;
    for (unsigned int j = 0; j < n_branches(); ++j)
      law.branches.push_back({branch_moduli[j] / 3., relaxation_times[j]});
    return law;
  }

  RubberLaw RubberModel::law_of_moduli(const double equilibrium) const
  {
    RubberLaw    law;
    const double r = table_mu2_over_mu1, G = equilibrium / 3.;
    if (model == MooneyRivlin::name)
      law.elastic =
        MooneyRivlin{mooney_rivlin.lambda, G / (1. + r), G * r / (1. + r)};
    else
      law.elastic = IsochoricMooneyRivlin{.5 * G / (1. + r),
                                          .5 * G * r / (1. + r),
                                          isochoric.bulk};
    return law;
  }

  RubberLaw RubberModel::at(const double f90) const
  {
    RubberLaw law;
    if (!has_tables())
      law = law_of_constants();
    else
      {
        if (tables == nullptr)
          check();
        if (!tables->equilibrium.contains(f90))
          {
            std::ostringstream text;
            text << "must lie within the table, " << tables->equilibrium.min()
                 << " to " << tables->equilibrium.max() << "; got " << f90
                 << ". Change it, or extend Material/table f90.";
            throw ExcParameter("Material/f90", text.str());
          }
        law = law_of_moduli(tables->equilibrium(f90));
        for (unsigned int j = 0; j < n_branches(); ++j)
          law.branches.push_back(
            {std::max(0., tables->branches[j](f90)) / 3., relaxation_times[j]});
      }
    for (MaxwellBranch &branch : law.branches)
      branch.relaxation_time *= shift.factor();
    law.branch_law = branch_law_by_name(branch_law);
    law.update     = update_by_name(update);
    law.density    = density;
    return law;
  }

  RubberLaw RubberModel::at(const double f90, const double temperature) const
  {
    TimeTemperatureShift shifted = shift;
    shifted.temperature          = temperature;
    shifted.check();
    RubberLaw law = at(f90);
    for (MaxwellBranch &branch : law.branches)
      branch.relaxation_time *= shifted.factor() / shift.factor();
    return law;
  }

  std::pair<double, double> RubberModel::f90_range() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!has_tables())
      return {-infinity, infinity};
    return {table_f90.front(), table_f90.back()};
  }

  void RubberModel::check() const
  {
    check_constants();
    check_viscosity();
    shift.check();
    check_tables();

    tables.reset();
    if (has_tables())
      {
        auto prepared =
          std::make_shared<Tables>(Tables{{table_f90, table_equilibrium}, {}});
        for (unsigned int j = 0; j < n_branches(); ++j)
          prepared->branches.emplace_back(table_f90,
                                          column(table_branch_moduli, j));
        tables = prepared;
        require_between_levels(tables->equilibrium,
                               table_f90,
                               1e-12 * table_equilibrium.front(),
                               "table equilibrium modulus");
        // A branch may fade out at a level; there round-off has either sign.
        for (const MonotoneTable &branch : tables->branches)
          require_between_levels(branch,
                                 table_f90,
                                 -1e-12 * table_equilibrium.front(),
                                 "table branch moduli");
      }
    check_f90();
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Finds what is wrong with section Material before anything is computed.
#include "base/monotone_table.h"
#include "base/parameter_error.h"
#include "material/rubber_model.h"

#include <deal.II/base/function_parser.h>

#include <cmath>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    template <typename... Pieces>
    [[noreturn]] void reject(const std::string &entry, const Pieces &...pieces)
    {
      std::ostringstream text;
      (text << ... << pieces);
      throw ExcParameter("Material/" + entry, text.str());
    }

    void require_positive(const std::string &entry,
                          const double       value,
                          const std::string &unit)
    {
      if (!(value > 0.) || !std::isfinite(value))
        reject(entry, "must be greater than 0 ", unit, "; got ", value, '.');
    }

    void require_moduli(const std::string         &entry,
                        const std::vector<double> &moduli)
    {
      for (unsigned int i = 0; i < moduli.size(); ++i)
        if (!(moduli[i] > 0.) || !std::isfinite(moduli[i]))
          reject(entry,
                 "must be greater than 0 MPa; got ",
                 moduli[i],
                 " as number ",
                 i + 1,
                 ". Leave out a branch that carries nothing.");
    }

    bool reads_as_number(const std::string &text, double &value)
    {
      std::istringstream stream(text);
      std::string        rest;
      return (stream >> value) && !(stream >> rest);
    }
  } // namespace

  void RubberModel::check_constants() const
  {
    require_positive("density", density, "t/mm^3");
    const bool constants = !has_tables();
    if (model == MooneyRivlin::name)
      {
        require_positive("lambda", mooney_rivlin.lambda, "MPa");
        if (constants)
          require_positive("mu1", mooney_rivlin.mu1, "MPa");
        if (mooney_rivlin.mu2 < 0.)
          reject("mu2",
                 "must be at least 0 MPa; got ",
                 mooney_rivlin.mu2,
                 ". A negative one makes the rubber unstable.");
      }
    else
      {
        require_positive("bulk modulus", isochoric.bulk, "MPa");
        if (constants)
          require_positive("C10", isochoric.C10, "MPa");
        if (isochoric.C01 < 0.)
          reject("C01",
                 "must be at least 0 MPa; got ",
                 isochoric.C01,
                 ". A negative one makes the rubber unstable.");
      }
  }

  void RubberModel::check_viscosity() const
  {
    if (branch_law != "isochoric neo-hooke" && update != "EXP2")
      reject("update",
             "must be left at EXP2 with Material/branch law = ",
             branch_law,
             ", whose update is exact for a linear path; got ",
             update,
             ". It chooses the update of isochoric neo-hooke branches.");
    for (unsigned int i = 0; i < relaxation_times.size(); ++i)
      {
        require_positive("relaxation times", relaxation_times[i], "s");
        for (unsigned int j = 0; j < i; ++j)
          if (relaxation_times[i] == relaxation_times[j])
            reject("relaxation times",
                   "must differ from each other; got ",
                   relaxation_times[i],
                   " s as numbers ",
                   j + 1,
                   " and ",
                   i + 1,
                   ". Join the two branches and add their moduli.");
      }
    require_moduli("branch moduli", branch_moduli);
    if (has_tables() && !branch_moduli.empty())
      reject("branch moduli",
             "must be empty beside Material/table f90; got ",
             branch_moduli.size(),
             " moduli and ",
             table_f90.size(),
             " levels. Put them into Material/table branch moduli.");
    if (!has_tables() && branch_moduli.size() != relaxation_times.size())
      reject("branch moduli",
             "must have one entry for each of the ",
             relaxation_times.size(),
             " entries of Material/relaxation times; got ",
             branch_moduli.size(),
             '.');
  }

  void RubberModel::check_tables() const
  {
    if (!has_tables())
      {
        if (!table_equilibrium.empty() || !table_branch_moduli.empty())
          reject("table f90",
                 "must name the levels of the other tables; got 0 levels for ",
                 table_equilibrium.size(),
                 " equilibrium moduli and ",
                 table_branch_moduli.size(),
                 " rows of branch moduli.");
        return;
      }

    const std::string levels = MonotoneTable::problem(table_f90, table_f90);
    if (!levels.empty())
      reject("table f90", levels);
    if (table_equilibrium.size() != table_f90.size())
      reject("table equilibrium modulus",
             "must have one entry for each of the ",
             table_f90.size(),
             " levels of Material/table f90; got ",
             table_equilibrium.size(),
             '.');
    require_moduli("table equilibrium modulus", table_equilibrium);

    const unsigned int n_rows = relaxation_times.empty() ? 0 : table_f90.size();
    if (table_branch_moduli.size() != n_rows)
      reject("table branch moduli",
             "must have ",
             n_rows,
             " rows, one for each level of Material/table f90 (0 without "
             "Material/relaxation times); got ",
             table_branch_moduli.size(),
             '.');
    for (unsigned int i = 0; i < n_rows; ++i)
      {
        if (table_branch_moduli[i].size() != relaxation_times.size())
          reject("table branch moduli",
                 "must have one number for each of the ",
                 relaxation_times.size(),
                 " entries of Material/relaxation times; got ",
                 table_branch_moduli[i].size(),
                 " in row ",
                 i + 1,
                 '.');
        for (const double E : table_branch_moduli[i])
          if (!(E >= 0.) || !std::isfinite(E))
            reject("table branch moduli",
                   "must be at least 0 MPa; got ",
                   E,
                   " in row ",
                   i + 1,
                   ", f90 = ",
                   table_f90[i],
                   ". A branch that gives energy back has no meaning.");
      }
  }

  bool RubberModel::f90_is_uniform() const
  {
    double value;
    return reads_as_number(f90, value);
  }

  double RubberModel::uniform_f90() const
  {
    double value;
    if (!reads_as_number(f90, value))
      reject("f90", "must be one number here; got the expression ", f90, '.');
    return value;
  }

  void RubberModel::check_f90() const
  {
    if (f90_is_uniform())
      {
        require_positive("f90", uniform_f90(), "[-]");
        at(uniform_f90());
        return;
      }
    try
      {
        FunctionParser<3> parser;
        parser.initialize("x,y,z", f90, {{"pi", numbers::PI}});
        parser.value(Point<3>());
      }
    catch (const std::exception &)
      {
        reject("f90",
               "must be a number or an expression in x, y, z [mm]; got \"",
               f90,
               "\". Powers are written ^, for example 0.8 + 0.02*z.");
      }
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Cure of a parameter file: how the compound cures.
#ifndef demold_cure_cure_parameters_h
#define demold_cure_cure_parameters_h

#include "cure/cure_model.h"

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Entries of Cure. The defaults are the natural rubber of theory A.3.
  class CureParameters
  {
  public:
    CureParameters();

    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws ExcParameter for tables that are none.
    void check() const;

    CureModel     model() const;
    OdeTolerances tolerances() const;

  private:
    /// All rates share one reference temperature, that of t90.
    struct Rate
    {
      double value, energy;

      void add_parameters(dealii::ParameterHandler &prm,
                          const std::string        &name,
                          const std::string        &symbol);
    };

    /// Value 0: no induction.
    struct Wait
    {
      double time, energy;

      void add_parameters(dealii::ParameterHandler &prm);
    };

    void add_laws(dealii::ParameterHandler &prm);

    ArrheniusRate rate(const Rate &entry) const;
    ArrheniusTime wait(const Wait &entry) const;

    double      reference_temperature = 160.;
    double      t90                   = 409.;
    double      activation_energy     = 98.5;
    std::string kinetics              = "equivalent time";
    double      tolerance             = 1e-8;

    std::vector<double> conversion_f90, conversion_degree;

    struct
    {
      Rate   k1 = {3.7e-6, 124.}, k2 = {5.39e-2, 94.6};
      double m = 1.037, n = 1.703;
      Wait   wait = {60., 90.};
    } kamal_sourour;
    struct
    {
      Rate   k    = {1.324e-2, 96.};
      double n    = 2.268;
      Wait   wait = {202.6, 96.5};
    } isayev_deng;
    struct
    {
      Rate k1 = {8e-3, 96.}, k2 = {3e-3, 96.}, k3 = {2e-4, 219.};
      Wait wait = {202.6, 96.5};
    } han;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Protocol: which rubber goes through which programme.
#ifndef demold_rig_protocol_parameters_h
#define demold_rig_protocol_parameters_h

#include "material/rubber_model.h"
#include "rig/loading.h"
#include "rig/rig_mode.h"

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  enum class Programme
  {
    ramp,
    relaxation,
    creep,
    cycles,
    frequency_sweep,
    rate_sweep
  };

  /// One run of the rig.
  struct ProtocolCase
  {
    double    f90;         ///< [-]
    double    temperature; ///< [degC]
    double    swept;       ///< frequency [Hz] of cycles, rate [1/s] of a sweep
    RubberLaw law;
    Loading   loading;
  };

  /// Sections Material and Protocol.
  struct ProtocolParameters
  {
    RubberModel material;

    std::string mode_name      = "uniaxial";
    std::string programme_name = "ramp";

    double              strain      = 0.5; ///< end or amplitude [-]
    double              mean_strain = 0.;  ///< of cycles [-]
    double              rate        = 1.;  ///< of the strain [1/s]; 0: at once
    double              stress      = 0.1; ///< nominal, creep [MPa]
    double              hold        = 0.;  ///< [s]
    std::string         shape       = "triangle"; ///< of cycles
    unsigned int        n_cycles    = 3;
    std::vector<double> frequencies = {1.};            ///< [Hz]
    std::vector<double> rates       = {0.01, 0.1, 1.}; ///< [1/s]
    std::vector<double> f90_levels, temperatures;      ///< empty: of Material

    double       time_step = 0.01; ///< [s]
    double       growth    = 1.;   ///< of the steps of a hold [-]
    unsigned int n_steps   = 200;  ///< of a cycle, or of a ramp of a sweep

    std::string reference = "none";
    double      tolerance = 1e-10; ///< of the reference

    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws ExcParameter.
    void check() const;

    RigMode   mode() const;
    Programme programme() const;
    bool      wants_reference() const;
    bool      has_cycles() const;

    /// f90 first, then temperatures, then what is swept, which runs fastest.
    std::vector<ProtocolCase> cases() const;

  private:
    void add_programme_entries(dealii::ParameterHandler &prm);
    void add_list_entries(dealii::ParameterHandler &prm);
    void add_step_entries(dealii::ParameterHandler &prm);
    void check_strains() const;
    void check_programme() const;
    void check_steps() const;
    bool is_sweep() const;

    Loading             loading(double swept) const;
    std::vector<double> swept_values() const;
  };
} // namespace demold

#endif

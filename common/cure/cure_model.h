// SPDX-License-Identifier: LGPL-2.1-or-later
// The state of cure of a point, integrated over its temperature history.
#ifndef demold_cure_cure_model_h
#define demold_cure_cure_model_h

#include "cure/kinetics.h"
#include "cure/ode_solver.h"
#include "cure/temperature_history.h"

#include "base/monotone_table.h"

#include <optional>
#include <vector>

namespace demold
{
  /// alpha over f90, two lists of the same length.
  struct Conversion
  {
    std::vector<double> f90, degree;
  };

  /// Of a natural rubber compound at 160 degC (theory A.3), from alpha = 0 at
  /// f90 = 0 to 0.988 at f90 = 1.5.
  Conversion default_conversion();

  /// How a compound cures.
  struct CureModel
  {
    /// t90 over temperature, for the equivalent time.
    ArrheniusTime t90 = {409., 98.5, 160.};

    /// The degree of cure, if there is a law of its own for it ...
    std::optional<Kinetics> kinetics;

    /// ... and where there is none: alpha over f90, held outside the table.
    MonotoneTable conversion = {default_conversion().f90,
                                default_conversion().degree};
  };

  /// The state of cure of a point; zeros are a raw compound.
  struct CureState
  {
    double       f90       = 0.; ///< equivalent time over t90 (theory A11) [-]
    double       induction = 0.; ///< int dt/t_i so far, at most 1 [-]
    KineticState inner     = {{0., 0., 0.}}; ///< of the kinetic law
  };

  /// alpha [-] of a point in @p state.
  double degree_of_cure(const CureModel &model, const CureState &state);

  /// Integrates f90 = int dt/t90(T), the induction and the kinetics over
  /// @p temperature with ARKODE. Returns the states at @p times [s],
  /// increasing; the first is @p initial. The end of the induction period is
  /// found as an event.
  std::vector<CureState> integrate_cure(const CureModel           &model,
                                        const TemperatureHistory  &temperature,
                                        const std::vector<double> &times,
                                        const OdeTolerances       &tolerances,
                                        const CureState           &initial);

  /// alpha [-] at @p times [s], increasing from 0 on, at constant
  /// @p temperature, from a raw compound: the closed form where there is one,
  /// else by ARKODE.
  std::vector<double>
  isothermal_degree_of_cure(const Kinetics            &kinetics,
                            const double               temperature,
                            const std::vector<double> &times,
                            const OdeTolerances       &tolerances);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables and include file of a cure fit.
#ifndef demold_identification_cure_fit_output_h
#define demold_identification_cure_fit_output_h

#include "identification/cure_fit.h"
#include "identification/parameter_include.h"

#include <string>
#include <vector>

namespace demold
{
  /// The curve at @p temperature [degC] in tables: "160 degC".
  std::string curve_name(double temperature);

  /// fit.csv in @p folder: degree of cure of data and model at every point.
  void write_fit(const std::string                 &folder,
                 const CureFit                     &fit,
                 const CureFitResult               &result,
                 const std::vector<RheometerCurve> &curves);

  /// times.csv in @p folder: torques, t10, t50, t90 and reversion of each
  /// curve.
  void write_times(const std::string                 &folder,
                   const std::vector<RheometerCurve> &curves);

  /// Section Cure: kinetics, and t90 over temperature [s].
  ParameterInclude cure_include(const Kinetics      &kinetics,
                                const ArrheniusTime &t90);
} // namespace demold

#endif

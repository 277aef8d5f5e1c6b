// SPDX-License-Identifier: LGPL-2.1-or-later
// Kinetics of cure from rheometer curves at several temperatures at once.
#ifndef demold_identification_cure_fit_h
#define demold_identification_cure_fit_h

#include "cure/arrhenius.h"
#include "cure/kinetics.h"
#include "cure/rheometer_curve.h"
#include "identification/fit_report.h"

#include <string>
#include <vector>

namespace demold
{
  /// A time and its standard error [s].
  struct PredictedTime
  {
    double value;
    double standard_error; ///< NaN where nothing can be said
  };

  /// A law fitted to all curves.
  struct CureFitResult
  {
    Kinetics            kinetics;
    FitReport           report;
    std::vector<double> rms;   ///< of alpha [-], for each curve
    std::vector<double> q;     ///< parameters as CureFit counts them
    double              slope; ///< what is left, see FitResult
  };

  /// Least squares on the degree of cure alpha at the points of the curves.
  /// Parameters are the logarithms of rates and times at the reference
  /// temperature, activation energies and exponents; the induction time of
  /// Kamal and Sourour has the energy of k2. Laws without reversion see the
  /// points up to the maximum torque, Han's all.
  class CureFit
  {
  public:
    /// @p law: the name of a law of kinetics.h; @p reference_temperature
    /// [degC]. At least two curves of different temperature.
    CureFit(const std::string                 &law,
            const std::vector<RheometerCurve> &curves,
            const double                       reference_temperature);

    CureFitResult fit() const;

    /// Is point @p i of @p curve fitted?
    bool uses(const RheometerCurve &curve, const unsigned int i) const;

    /// t90 of the law at @p temperature [degC], counted as in a rheometer, with
    /// the uncertainty that follows from that of the parameters.
    PredictedTime t90(const CureFitResult &result,
                      const double         temperature) const;

  private:
    struct Parameter
    {
      std::string name;
      double      start, lower, upper;
    };

    Kinetics            kinetics(const std::vector<double> &q) const;
    std::vector<double> residuals(const std::vector<double> &q) const;
    double              t90(const Kinetics &law, double temperature) const;

    void add_rate(const std::string &name, double value, double energy);
    void add_parameters();
    void name_in_units(CureFitResult &result) const;

    std::string                 law;
    std::vector<RheometerCurve> curves;
    double                      reference_temperature;
    std::vector<Parameter>      parameters;
  };

  /// ln t_x over 1/T of all curves, x = @p degree, as a straight line.
  ArrheniusFit fit_cure_times(const std::vector<RheometerCurve> &curves,
                              const double                       degree,
                              const double reference_temperature);

  /// t_x of a further curve at @p temperature [degC] by the line, with the
  /// scatter of one curve.
  PredictedTime predict(const ArrheniusFit &line, const double temperature);
} // namespace demold

#endif

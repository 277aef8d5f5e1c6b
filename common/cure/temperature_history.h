// SPDX-License-Identifier: LGPL-2.1-or-later
// A temperature over time: constant, table, formula or function.
#ifndef demold_cure_temperature_history_h
#define demold_cure_temperature_history_h

#include <functional>
#include <string>
#include <vector>

namespace demold
{
  /// T(t) [degC] for t [s], with the times where T or its slope jumps. A value.
  class TemperatureHistory
  {
  public:
    /// The same temperature at all times.
    explicit TemperatureHistory(const double temperature = 20.);

    /// Any function; integrators stop at @p breakpoints (increasing).
    TemperatureHistory(const std::function<double(double)> &function,
                       const std::vector<double>           &breakpoints);

    /// Straight lines between points, constant outside them; @p times strictly
    /// increasing.
    static TemperatureHistory table(const std::vector<double> &times,
                                    const std::vector<double> &temperatures);

    /// What a parameter file says: "165", "0: 30, 60: 165, 600: 168" (times
    /// and temperatures) or a formula in t. Throws ExcParameter with @p path.
    static TemperatureHistory parse(const std::string &text,
                                    const std::string &path);

    double operator()(const double time) const
    {
      return function(time);
    }

    std::vector<double> breakpoints;

  private:
    std::function<double(double)> function;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// A temperature over time: constant, table, formula or function.
#include "cure/temperature_history.h"

#include "base/parameter_error.h"
#include "cure/arrhenius.h"

#include <deal.II/base/function_parser.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// The whole of @p text as a number.
    bool read_number(const std::string &text, double &number)
    {
      char *end          = nullptr;
      number             = std::strtod(text.c_str(), &end);
      const bool nothing = end == text.c_str();
      while (*end == ' ' || *end == '\t')
        ++end;
      return !nothing && *end == '\0';
    }



    /// "0: 30, 60: 165" as times and temperatures; false if it is no such list.
    bool read_table(const std::string   &text,
                    std::vector<double> &times,
                    std::vector<double> &temperatures)
    {
      std::istringstream in(text);
      std::string        item;
      while (std::getline(in, item, ','))
        {
          const auto colon = item.find(':');
          double     time, temperature;
          if (colon == std::string::npos ||
              !read_number(item.substr(0, colon), time) ||
              !read_number(item.substr(colon + 1), temperature))
            return false;
          times.push_back(time);
          temperatures.push_back(temperature);
        }
      return !times.empty();
    }



    void check_absolute(const double temperature, const std::string &path)
    {
      if (!(kelvin(temperature) > 0. && std::isfinite(temperature)))
        throw ExcParameter(path,
                           "must stay above -273.15 degC; got " +
                             std::to_string(temperature) +
                             " degC. Temperatures are in degC.");
    }



    TemperatureHistory parse_formula(const std::string &text,
                                     const std::string &path)
    {
      const auto parser = std::make_shared<FunctionParser<1>>();
      try
        {
          parser->initialize("t", text, {{"pi", numbers::PI}});
          parser->value(Point<1>(0.));
        }
      catch (const std::exception &)
        {
          throw ExcParameter(path,
                             "must be a temperature [degC], a table \"time: "
                             "temperature, ...\" or a formula in t [s], for "
                             "example 0: 30, 60: 165 or min(30 + 2*t, 165); "
                             "got \"" +
                               text + "\".");
        }
      const auto function = [parser, path](const double time) {
        const double temperature = parser->value(Point<1>(time));
        check_absolute(temperature, path);
        return temperature;
      };
      function(0.);
      return TemperatureHistory(function, {});
    }
  } // namespace



  TemperatureHistory::TemperatureHistory(const double temperature)
    : function([temperature](const double) { return temperature; })
  {}

  TemperatureHistory::TemperatureHistory(
    const std::function<double(double)> &function,
    const std::vector<double>           &breakpoints)
    : breakpoints(breakpoints)
    , function(function)
  {}



  TemperatureHistory
  TemperatureHistory::table(const std::vector<double> &times,
                            const std::vector<double> &temperatures)
  {
    const auto between = [times, temperatures](const double time) {
      if (time <= times.front())
        return temperatures.front();
      if (time >= times.back())
        return temperatures.back();
      const std::size_t i =
        std::upper_bound(times.begin(), times.end(), time) - times.begin();
      const double share = (time - times[i - 1]) / (times[i] - times[i - 1]);
      return temperatures[i - 1] +
             share * (temperatures[i] - temperatures[i - 1]);
    };
    return TemperatureHistory(between, times);
  }



  TemperatureHistory TemperatureHistory::parse(const std::string &text,
                                               const std::string &path)
  {
    double              constant;
    std::vector<double> times, temperatures;
    if (read_number(text, constant))
      {
        check_absolute(constant, path);
        return TemperatureHistory(constant);
      }
    if (!read_table(text, times, temperatures))
      return parse_formula(text, path);
    for (std::size_t i = 0; i < times.size(); ++i)
      {
        check_absolute(temperatures[i], path);
        if (i > 0 && !(times[i] > times[i - 1]))
          throw ExcParameter(path,
                             "needs times that increase strictly; got " +
                               std::to_string(times[i]) + " s after " +
                               std::to_string(times[i - 1]) +
                               " s. Sort the table.");
      }
    return table(times, temperatures);
  }
} // namespace demold

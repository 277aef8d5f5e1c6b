// SPDX-License-Identifier: LGPL-2.1-or-later
// What a rheometer curve says: degree of cure, t90, reversion, modulus.
#include "cure/rheometer_curve.h"

#include "base/monotone_table.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace demold
{
  namespace
  {
    constexpr double pi = 3.14159265358979323846;

    std::size_t index_of_maximum(const std::vector<double> &torques)
    {
      return std::max_element(torques.begin(), torques.end()) - torques.begin();
    }

    std::size_t index_of_minimum(const std::vector<double> &torques)
    {
      return std::min_element(torques.begin(),
                              torques.begin() + index_of_maximum(torques) + 1) -
             torques.begin();
    }
  } // namespace



  std::string RheometerCurve::problem(const std::vector<double> &times,
                                      const std::vector<double> &torques)
  {
    const std::string why_not = MonotoneTable::problem(times, torques);
    if (!why_not.empty())
      return why_not;
    std::ostringstream text;
    const auto lowest = std::min_element(torques.begin(), torques.end());
    if (times.front() < 0.)
      text << "needs times from 0 on; got " << times.front() << " s.";
    else if (*lowest <= 0.)
      text << "needs positive torques; point " << lowest - torques.begin() + 1
           << " is " << *lowest << " dNm.";
    else if (index_of_maximum(torques) == index_of_minimum(torques))
      text << "needs a torque that rises with time; the largest, "
           << torques.front() << " dNm, is the first.";
    return text.str();
  }



  RheometerCurve::RheometerCurve(const double               temperature,
                                 const std::vector<double> &times,
                                 const std::vector<double> &torques)
    : temperature(temperature)
    , times(times)
    , torques(torques)
  {
    const std::string why_not = problem(times, torques);
    if (!why_not.empty())
      throw std::invalid_argument("A rheometer curve " + why_not);
    const std::size_t i_min = index_of_minimum(torques),
                      i_max = index_of_maximum(torques);
    minimum                 = torques[i_min];
    maximum                 = torques[i_max];
    time_of_minimum         = times[i_min];
    time_of_maximum         = times[i_max];
    curve                   = MonotoneTable(times, torques);
  }



  double RheometerCurve::torque(const double time) const
  {
    return curve(time);
  }



  double RheometerCurve::degree_of_cure(const double time) const
  {
    return time <= time_of_minimum ?
             0. :
             (torque(time) - minimum) / (maximum - minimum);
  }



  std::vector<double> RheometerCurve::degrees_of_cure() const
  {
    std::vector<double> degrees;
    for (const double t : times)
      degrees.push_back(degree_of_cure(t));
    return degrees;
  }



  double RheometerCurve::time_of(const double degree) const
  {
    if (!(degree > 0. && degree <= 1.))
      throw std::invalid_argument("t_x needs a degree of cure in (0, 1]");
    std::size_t i = 0;
    while (times[i] <= time_of_minimum || degree_of_cure(times[i]) < degree)
      ++i;
    const auto excess = [&](const double t) {
      return degree_of_cure(t) - degree;
    };
    const double at_end = excess(times[i]);
    if (at_end == 0.)
      return times[i];
    std::uintmax_t n_iterations = 100;
    const auto     bracket      = boost::math::tools::toms748_solve(
      excess,
      times[i - 1],
      times[i],
      boost::math::tools::eps_tolerance<double>(50),
      n_iterations);
    return .5 * (bracket.first + bracket.second);
  }



  double RheometerCurve::reversion() const
  {
    return (maximum - torques.back()) / (maximum - minimum);
  }



  double shear_modulus_from_torque(const double         torque,
                                   const RheometerCell &cell)
  {
    // 1 dNm = 100 N mm
    return 3. * 100. * torque /
           (2. * pi * std::pow(cell.radius, 3.) * cell.shear_strain);
  }
} // namespace demold

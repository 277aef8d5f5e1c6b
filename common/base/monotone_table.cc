// SPDX-License-Identifier: LGPL-2.1-or-later
// Monotone interpolation by Boost's pchip.
#include "base/monotone_table.h"

// Boost 1.74's pchip calls isnan without a namespace.
#include <math.h>

#include <boost/math/interpolators/pchip.hpp>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace demold
{
  std::string MonotoneTable::problem(const std::vector<double> &x,
                                     const std::vector<double> &y)
  {
    std::ostringstream text;
    if (x.size() < n_points_min)
      text << "needs at least " << n_points_min << " points; got " << x.size()
           << '.';
    else if (x.size() != y.size())
      text << "needs one value per point; got " << y.size() << " values for "
           << x.size() << " points.";
    else
      for (std::size_t i = 0; i < x.size() && text.tellp() == 0; ++i)
        if (!std::isfinite(x[i]) || !std::isfinite(y[i]))
          text << "needs finite numbers; point " << i + 1 << " is not.";
        else if (i > 0 && !(x[i] > x[i - 1]))
          text << "must increase strictly; got " << x[i] << " after "
               << x[i - 1] << '.';
    return text.str();
  }

  MonotoneTable::MonotoneTable(const std::vector<double> &x,
                               const std::vector<double> &y)
  {
    const std::string why_not = problem(x, y);
    if (!why_not.empty())
      throw std::invalid_argument("A table " + why_not);
    first = x.front();
    last  = x.back();
    curve = boost::math::interpolators::pchip<std::vector<double>>(
      std::vector<double>(x),
      std::vector<double>(y));
  }

  double MonotoneTable::operator()(const double x) const
  {
    if (!contains(x))
      {
        std::ostringstream text;
        text << "The table covers " << first << " to " << last << "; got " << x
             << '.';
        throw std::out_of_range(text.str());
      }
    return curve(x);
  }
} // namespace demold

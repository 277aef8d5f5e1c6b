// SPDX-License-Identifier: LGPL-2.1-or-later
// A tabulated curve, interpolated without overshoot.
#ifndef demold_base_monotone_table_h
#define demold_base_monotone_table_h

#include <functional>
#include <string>
#include <vector>

namespace demold
{
  /// A curve y(x) through given points by PCHIP: piecewise cubic, with a
  /// continuous slope, monotone wherever the points are. A value; copies share
  /// the table.
  class MonotoneTable
  {
  public:
    /// Fewer points are not interpolated (a limit of Boost's pchip).
    static constexpr unsigned int n_points_min = 4;

    /// Why no curve goes through these points; empty if one does. For callers
    /// that report it under the path of their own entry.
    static std::string problem(const std::vector<double> &x,
                               const std::vector<double> &y);

    /// @p x strictly increasing, as many @p y; throws std::invalid_argument
    /// with problem(x, y) otherwise.
    MonotoneTable(const std::vector<double> &x, const std::vector<double> &y);

    /// The first and the last x.
    double min() const
    {
      return first;
    }
    double max() const
    {
      return last;
    }

    /// Does the table hold a value at @p x? False for a NaN.
    bool contains(const double x) const
    {
      return x >= first && x <= last;
    }

    /// y(x), the given y at the given x; throws std::out_of_range outside.
    double operator()(double x) const;

  private:
    double                        first, last;
    std::function<double(double)> curve;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// What accuracy costs: observed orders and the Pareto front of a set of runs.
#ifndef demold_study_accuracy_h
#define demold_study_accuracy_h

#include <vector>

namespace demold
{
  /// Observed order [-] p of an error that behaves as h^p: the errors of a
  /// coarser and of a finer run, whose refined entry has the values @p coarse
  /// and @p fine. The entry may be a size or a count: only the ratio of its
  /// values enters, so p is positive if the error has become smaller. NaN where
  /// p is undefined (an error or a value that is not positive, equal values).
  double observed_order(const double coarse_error,
                        const double fine_error,
                        const double coarse,
                        const double fine);

  /// The same for a whole series, coarse to fine: the slope of the least
  /// squares line through ln(error) over ln(value). Errors below @p round_off
  /// and NaN do not count. NaN with less than two points.
  double fitted_order(const std::vector<double> &errors,
                      const std::vector<double> &values,
                      const double               round_off);

  /// Is run i on the Pareto front, that is: has no other run a smaller error
  /// at no more time, or less time at no larger error? Runs with a NaN are not
  /// on it.
  std::vector<bool> pareto_front(const std::vector<double> &times,
                                 const std::vector<double> &errors);
} // namespace demold

#endif

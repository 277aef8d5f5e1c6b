// SPDX-License-Identifier: LGPL-2.1-or-later
// Prony series of one compound at several states of cure, times in common.
#ifndef demold_identification_prony_fit_h
#define demold_identification_prony_fit_h

#include "identification/fit_report.h"
#include "identification/prony_curve.h"

#include <vector>

namespace demold
{
  /// Series for all curves, of the same relaxation times: those of a table
  /// over f90.
  struct PronyResult
  {
    std::vector<PronySeries> series; ///< one for each curve
    std::vector<double>      rms;    ///< of the weighted residuals [-], each
    FitReport                report; ///< over all curves
    double                   slope;  ///< what is left, see FitResult
    unsigned int             n_parameters; ///< that are not zero

    /// Akaike's criterion with the correction for few data (Hurvich and Tsai
    /// 1989): n ln(rss/n) + 2 k + 2 k (k+1)/(n-k-1); the series of the smallest
    /// value is worth its parameters. Infinite if n <= k + 1.
    double criterion() const;
  };

  /// Nonnegative moduli (theory A.4, NNLS of the stacked weighted rows).
  struct PronyFit
  {
    /// E_inf [MPa] of each curve where it is known from static tests; negative
    /// or missing: fitted.
    std::vector<double> equilibrium;

    /// Moduli for fixed @p times [s]: the exact minimum.
    PronyResult fit_moduli(const std::vector<PronyCurve> &curves,
                           const std::vector<double>     &times) const;

    /// Moduli and times, the latter between @p shortest and @p longest [s],
    /// from @p times on: a local minimum, never worse than the start.
    PronyResult fit_times(const std::vector<PronyCurve> &curves,
                          const std::vector<double>     &times,
                          double                         shortest,
                          double                         longest) const;
  };

  /// @p n times [s], equally spaced in their logarithm, both ends included;
  /// one: the geometric mean.
  std::vector<double> logarithmic_times(double       shortest,
                                        double       longest,
                                        unsigned int n);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// The parameters of an elastic law from slow tests in several modes at once.
#ifndef demold_identification_static_fit_h
#define demold_identification_static_fit_h

#include "identification/fit_report.h"
#include "identification/static_law.h"
#include "rig/rig_mode.h"

#include <string>
#include <vector>

namespace demold
{
  /// The largest principal stretch of @p mode at @p x, which is a stretch, or
  /// the shear in simple shear, of incompressible rubber [-].
  double largest_stretch(RigMode mode, double x);

  /// A measured curve.
  struct TestCurve
  {
    RigMode             mode = RigMode::uniaxial; ///< not confined
    std::vector<double> x;                        ///< stretch, or shear [-]
    std::vector<double> stress;                   ///< nominal [MPa]
  };

  /// Where a static fit has ended.
  struct StaticFitResult
  {
    FitReport report;

    /// R^2 of the stresses themselves, whatever their weights, over all
    /// curves [-].
    double determination;

    double slope; ///< what is left, see FitResult; 0 of a linear law

    /// The values of the parameters.
    std::vector<double> values() const;
  };

  /// Least squares between the bounds of the law (theory A.4): linear where the
  /// law is, else by minimise() from the incompressible Mooney-Rivlin fit on,
  /// to which it finds the nearest minimum.
  struct StaticFit
  {
    bool   relative = false; ///< weights 1/max(|P|, floor) instead of 1
    double floor    = 0.01;  ///< [MPa]

    /// Data beyond this principal stretch are left out [-].
    double max_stretch = 1e3;

    /// Are the data at @p x used?
    bool uses(RigMode mode, double x) const;

    /// How many data are.
    unsigned int n_used(const std::vector<TestCurve> &curves) const;

    /// 1, or 1/MPa if relative.
    double weight(double stress) const;

    /// At least one datum of @p curves must be within the largest stretch, and
    /// as many as @p law has parameters.
    StaticFitResult fit(const StaticLaw              &law,
                        const std::vector<TestCurve> &curves) const;
  };

  /// What tests in the modes of @p curves cannot tell of mu1 and mu2 of Mooney
  /// and Rivlin, in a sentence; empty for two modes or more, of which one is
  /// not shear. The statistics of the report do not see it: they take what the
  /// model misses for scatter.
  std::string advice_on_modes(const std::vector<TestCurve> &curves,
                              const FitReport              &report);
} // namespace demold

#endif

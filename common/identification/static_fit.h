// SPDX-License-Identifier: LGPL-2.1-or-later
// The moduli of Mooney and Rivlin from slow tests in several modes at once.
#ifndef demold_identification_static_fit_h
#define demold_identification_static_fit_h

#include "identification/fit_report.h"

#include <array>
#include <string>
#include <vector>

namespace demold
{
  /// A homogeneous deformation of incompressible rubber.
  enum class TestMode
  {
    uniaxial,
    equibiaxial,
    pure_shear,
    simple_shear
  };

  std::string in_words(TestMode mode); ///< "pure shear"

  /// dP/dmu1 and dP/dmu2 [-] of the nominal stress, which is linear in the
  /// moduli (theory A.1, incompressible), at the stretch @p x, or at the shear
  /// gamma in simple shear [-]:
  ///   uniaxial     P = (mu1 + mu2/x) (x - x^-2)
  ///   equibiaxial  P = (mu1 + mu2 x^2) (x - x^-5)
  ///   pure shear   P = (mu1 + mu2) (x - x^-3)
  ///   simple shear P = (mu1 + mu2) x
  std::array<double, 2> stress_by_moduli(TestMode mode, double x);

  /// The largest principal stretch of @p mode at @p x [-].
  double largest_stretch(TestMode mode, double x);

  /// A measured curve.
  struct TestCurve
  {
    TestMode            mode = TestMode::uniaxial;
    std::vector<double> x;      ///< stretch, or shear [-]
    std::vector<double> stress; ///< nominal [MPa]
  };

  /// Linear least squares with mu1, mu2 >= 0 (theory A.4), which makes the
  /// energy polyconvex.
  struct StaticFit
  {
    bool   relative = false; ///< weights 1/max(|P|, floor) instead of 1
    double floor    = 0.01;  ///< [MPa]

    /// Data beyond this principal stretch are left out [-].
    double max_stretch = 1e3;

    /// Are the data at @p x used?
    bool uses(TestMode mode, double x) const;

    /// 1, or 1/MPa if relative.
    double weight(double stress) const;

    /// Parameters mu1, mu2 [MPa]. At least one of @p curves must have data
    /// within the largest stretch.
    FitReport fit(const std::vector<TestCurve> &curves) const;
  };

  /// What tests in the modes of @p curves cannot tell, in a sentence; empty for
  /// two modes or more, of which one is not shear. The statistics of the report
  /// do not see it: they take what the model misses for scatter.
  std::string advice_on_modes(const std::vector<TestCurve> &curves,
                              const FitReport              &report);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables and include file of a static fit.
#ifndef demold_identification_static_fit_output_h
#define demold_identification_static_fit_output_h

#include "identification/parameter_include.h"
#include "identification/static_fit.h"

#include <string>
#include <vector>

namespace demold
{
  /// fit.csv in @p folder: data, model and residual of every row; weight 0
  /// where it is not used.
  void write_fit(const std::string            &folder,
                 const StaticFit              &fit,
                 const StaticLaw              &law,
                 const std::vector<double>    &parameters,
                 const std::vector<TestCurve> &curves);

  /// range.csv in @p folder: how the parameters depend on the largest stretch
  /// that is used, from two data more than parameters on. Constants of the
  /// rubber would not.
  void write_range(const std::string            &folder,
                   StaticFit                     fit,
                   const StaticLaw              &law,
                   const std::vector<TestCurve> &curves);

  /// Section Material of Mooney-Rivlin rubber; @p lambda [MPa].
  ParameterInclude static_material(double lambda, double mu1, double mu2);
} // namespace demold

#endif

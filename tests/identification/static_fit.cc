// SPDX-License-Identifier: LGPL-2.1-or-later
// mu1 and mu2 from slow tests, as published for Treloar's rubber.
#include "identification/static_fit.h"

#include "base/data_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
  using namespace demold;

  TestCurve treloar(const RigMode mode)
  {
    const auto data =
      read_data_file(std::string(DEMOLD_SOURCE_DIR) +
                       "/prm/step-material/data/treloar-" + name_of(mode) +
                       ".csv",
                     {{"stretch [-]"}, {"nominal stress [MPa]"}});
    return {mode, data.columns[0], data.columns[1]};
  }

  FitReport fit(const std::vector<TestCurve> &curves, const double max_stretch)
  {
    StaticFit fit;
    fit.max_stretch = max_stretch;
    return fit.fit(incompressible_mooney_rivlin(), curves).report;
  }

  // Expected values: theory A.4, an independent nonnegative least squares.
  TEST(static_fit, reproduces_the_moduli_of_treloars_rubber)
  {
    const auto uniaxial = treloar(RigMode::uniaxial),
               biaxial  = treloar(RigMode::equibiaxial);
    const auto one      = fit({uniaxial}, 1.6);
    EXPECT_NEAR(one.parameters[0].value, .20332, 1e-5);
    EXPECT_NEAR(one.parameters[1].value, .22236, 1e-5);
    EXPECT_NEAR(one.rms, 3.1e-4, 1e-5);
    const auto both = fit({uniaxial, biaxial}, 1.6);
    EXPECT_NEAR(both.parameters[0].value, .33578, 1e-5);
    EXPECT_NEAR(both.parameters[1].value, .04272, 1e-5);
    EXPECT_NEAR(both.rms, .0147, 1e-4);
    const auto wide = fit({uniaxial, biaxial}, 3.1);
    EXPECT_NEAR(wide.parameters[0].value, .32068, 1e-5);
    EXPECT_NEAR(wide.parameters[1].value, .01107, 1e-5);
  }

  TEST(static_fit, says_that_uniaxial_data_alone_do_not_identify_mu2)
  {
    const auto uniaxial = treloar(RigMode::uniaxial),
               biaxial  = treloar(RigMode::equibiaxial);
    EXPECT_EQ(advice_on_modes({uniaxial}, fit({uniaxial}, 1.6))
                .rfind("Uniaxial data alone do not identify mu2", 0),
              0u);
    EXPECT_EQ(advice_on_modes({uniaxial, biaxial},
                              fit({uniaxial, biaxial}, 1.6)),
              "");
  }

  TEST(static_fit, recovers_moduli_from_exact_stresses_in_all_modes)
  {
    std::vector<TestCurve> curves;
    for (const auto mode : {RigMode::uniaxial,
                            RigMode::equibiaxial,
                            RigMode::pure_shear,
                            RigMode::simple_shear})
      {
        TestCurve curve;
        curve.mode = mode;
        for (const double x : {.7, 1.2, 1.9})
          {
            const double squeeze =
              mode == RigMode::equibiaxial ? x - std::pow(x, -5.) :
              mode == RigMode::uniaxial    ? x - std::pow(x, -2.) :
              mode == RigMode::pure_shear  ? x - std::pow(x, -3.) :
                                             x;
            const double share = mode == RigMode::equibiaxial ? x * x :
                                 mode == RigMode::uniaxial    ? 1. / x :
                                                                1.;
            curve.x.push_back(x);
            curve.stress.push_back((.4 + .1 * share) * squeeze);
          }
        curves.push_back(curve);
      }
    for (const bool relative : {false, true})
      {
        StaticFit fit;
        fit.relative      = relative;
        const auto result = fit.fit(incompressible_mooney_rivlin(), curves);
        EXPECT_NEAR(result.values()[0], .4, 1e-12);
        EXPECT_NEAR(result.values()[1], .1, 1e-12);
        EXPECT_NEAR(result.determination, 1., 1e-12);
      }
  }

  TEST(static_fit, shear_data_alone_determine_only_the_sum)
  {
    const TestCurve shear{RigMode::simple_shear, {.1, .5, 1.}, {.05, .25, .5}};
    const auto      report = fit({shear}, 10.);
    EXPECT_NEAR(report.parameters[0].value + report.parameters[1].value,
                .5,
                1e-12);
    EXPECT_NE(advice_on_modes({shear}, report).find("only the sum"),
              std::string::npos);
  }

  // One parameter, three points: mu = sum a P/sum a^2 with a = x - x^-3, as
  // pure shear identifies only mu1 + mu2. R^2 from its definition.
  TEST(static_fit, R2_is_the_share_of_the_scatter_that_the_law_explains)
  {
    const TestCurve shear{RigMode::pure_shear, {1.1, 1.5, 2.}, {.2, .5, 1.1}};
    double          aP = 0., aa = 0., mean = 0.;
    for (unsigned int i = 0; i < 3; ++i)
      {
        const double a = shear.x[i] - std::pow(shear.x[i], -3);
        aP += a * shear.stress[i];
        aa += a * a;
        mean += shear.stress[i] / 3.;
      }
    double left = 0., all = 0.;
    for (unsigned int i = 0; i < 3; ++i)
      {
        const double a = shear.x[i] - std::pow(shear.x[i], -3);
        left += std::pow(shear.stress[i] - aP / aa * a, 2);
        all += std::pow(shear.stress[i] - mean, 2);
      }
    const auto result =
      StaticFit().fit(incompressible_mooney_rivlin(), {shear});
    EXPECT_NEAR(result.determination, 1. - left / all, 1e-12);
    EXPECT_NEAR(result.report.rms, std::sqrt(left / 3.), 1e-12);
  }
} // namespace

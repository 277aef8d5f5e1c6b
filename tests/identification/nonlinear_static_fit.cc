// SPDX-License-Identifier: LGPL-2.1-or-later
// Laws that are not linear in their parameters, from several modes at once.
#include "identification/static_fit.h"

#include "base/data_file.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>

namespace
{
  using namespace demold;

  constexpr RigMode all_modes[] = {RigMode::uniaxial,
                                   RigMode::equibiaxial,
                                   RigMode::pure_shear,
                                   RigMode::simple_shear};

  std::vector<TestCurve> treloar()
  {
    std::vector<TestCurve> curves;
    for (const RigMode mode : {RigMode::uniaxial, RigMode::equibiaxial})
      {
        const auto data =
          read_data_file(std::string(DEMOLD_SOURCE_DIR) +
                           "/prm/step-material/data/treloar-" + name_of(mode) +
                           ".csv",
                         {{"stretch [-]"}, {"nominal stress [MPa]"}});
        curves.push_back({mode, data.columns[0], data.columns[1]});
      }
    return curves;
  }

  struct Moduli
  {
    double lambda, mu1, mu2;
  };

  /// Principal Cauchy stress times J [MPa] (theory A3) of stretch @p i.
  double kirchhoff(const Moduli                &m,
                   const std::array<double, 3> &l,
                   unsigned int                 i)
  {
    const double I1 = l[0] * l[0] + l[1] * l[1] + l[2] * l[2];
    const double J = l[0] * l[1] * l[2], b = l[i] * l[i];
    return m.mu1 * (b - 1.) + m.mu2 * (I1 * b - b * b - 2.) +
           .5 * m.lambda * (J * J - 1.);
  }

  /// Nominal stress [MPa] of compressible rubber pulled to @p x: the side,
  /// free of stress, is found by halving.
  double compressible_stress(const Moduli &m, RigMode mode, double x)
  {
    if (mode == RigMode::simple_shear)
      return (m.mu1 + m.mu2) * x; // (A3): J = 1, b_12 = x
    const auto stretches = [&](const double l) -> std::array<double, 3> {
      return {{x,
               mode == RigMode::uniaxial    ? l :
               mode == RigMode::equibiaxial ? x :
                                              1.,
               l}};
    };
    double low = .01, high = 10.;
    for (unsigned int i = 0; i < 100; ++i)
      {
        const double l                                    = .5 * (low + high);
        (kirchhoff(m, stretches(l), 2) < 0. ? low : high) = l;
      }
    return kirchhoff(m, stretches(low), 0) / x;
  }

  TestCurve curve(const RigMode                        mode,
                  const std::function<double(double)> &stress)
  {
    TestCurve result;
    result.mode = mode;
    for (const double x : {.7, 1.2, 1.5, 1.9, 2.6})
      {
        result.x.push_back(x);
        result.stress.push_back(stress(x));
      }
    return result;
  }

  // Reference values of theory A.1, Lambda = 50, mu1 = 0.4, mu2 = 0.1 MPa.
  TEST(compressible_mooney_rivlin, of_published_stresses_is_that_behind_them)
  {
    const TestCurve uniaxial{RigMode::uniaxial,
                             {.8, 1.2, 1.5, 2.},
                             {-.39785933, .24390404, .49221603, .78741328}};
    const auto      result =
      StaticFit().fit(compressible_mooney_rivlin(50.), {uniaxial});
    EXPECT_NEAR(result.values()[0], .4, 1e-6);
    EXPECT_NEAR(result.values()[1], .1, 1e-6);
    EXPECT_LT(result.report.rms, 1e-8);
  }

  TEST(compressible_mooney_rivlin, moduli_are_recovered_from_all_modes_at_once)
  {
    for (const Moduli truth : {Moduli{5., .4, .1}, Moduli{50., .25, .2}})
      for (const bool relative : {false, true})
        {
          std::vector<TestCurve> curves;
          for (const RigMode mode : all_modes)
            curves.push_back(curve(mode, [&](const double x) {
              return compressible_stress(truth, mode, x);
            }));
          StaticFit fit;
          fit.relative = relative;
          const auto result =
            fit.fit(compressible_mooney_rivlin(truth.lambda), curves);
          EXPECT_NEAR(result.values()[0], truth.mu1, 1e-9);
          EXPECT_NEAR(result.values()[1], truth.mu2, 1e-9);
          EXPECT_NEAR(result.determination, 1., 1e-12);
        }
  }

  // J - 1 falls as 1/Lambda, and so does all that depends on it.
  TEST(compressible_mooney_rivlin, tends_to_the_linear_fit_as_1_over_lambda)
  {
    StaticFit fit;
    fit.max_stretch   = 1.6;
    const auto curves = treloar();
    const auto limit = fit.fit(incompressible_mooney_rivlin(), curves).values();
    const auto distant = [&](const double lambda) {
      const auto q =
        fit.fit(compressible_mooney_rivlin(lambda), curves).values();
      return std::hypot(q[0] - limit[0], q[1] - limit[1]);
    };
    const double far = distant(1e3), near = distant(1e4);
    EXPECT_GT(far, 1e-7);
    EXPECT_NEAR(far / near, 10., .2);
  }

  TEST(compressible_mooney_rivlin, stops_at_a_bound_and_says_so)
  {
    // Stresses of mu2 < 0 in shear-free modes: the best admissible is 0.
    std::vector<TestCurve> curves;
    for (const RigMode mode : {RigMode::uniaxial, RigMode::equibiaxial})
      curves.push_back(curve(mode, [&](const double x) {
        return compressible_stress({50., .5, -.02}, mode, x);
      }));
    const auto result =
      StaticFit().fit(compressible_mooney_rivlin(50.), curves);
    EXPECT_EQ(result.values()[1], 0.);
    EXPECT_NE(result.report.identifiability().find(
                "mu2 is held by its bound 0 MPa"),
              std::string::npos);
    EXPECT_LT(result.slope, 1e-6);
  }

  /// Ogden's energy [mJ/mm^3] of the stretches that belong to @p x.
  double ogden_energy(const std::vector<double> &q, RigMode mode, double x)
  {
    const double          l = .5 * x + std::sqrt(1. + .25 * x * x);
    std::array<double, 3> stretches{{x, 1. / std::sqrt(x), 1. / std::sqrt(x)}};
    if (mode == RigMode::equibiaxial)
      stretches = {{x, x, 1. / (x * x)}};
    if (mode == RigMode::pure_shear)
      stretches = {{x, 1., 1. / x}};
    if (mode == RigMode::simple_shear)
      stretches = {{l, 1., 1. / l}};
    double W = 0.;
    for (unsigned int p = 0; p < q.size(); p += 2)
      for (const double stretch : stretches)
        W += 2. * q[p] / (q[p + 1] * q[p + 1]) *
             (std::pow(stretch, q[p + 1]) - 1.);
    return W;
  }

  /// Work of the grips is the energy: dW/dx for each direction pulled.
  double ogden_stress(const std::vector<double> &q, RigMode mode, double x)
  {
    constexpr double h = 1e-5;
    return (ogden_energy(q, mode, x + h) - ogden_energy(q, mode, x - h)) /
           (2. * h) / (mode == RigMode::equibiaxial ? 2. : 1.);
  }

  TEST(ogden, both_terms_are_recovered_from_all_modes_at_once)
  {
    const std::vector<double> truth{.35, 3.1, .05, -1.6};
    std::vector<TestCurve>    curves;
    for (const RigMode mode : all_modes)
      curves.push_back(curve(mode, [&](const double x) {
        return ogden_stress(truth, mode, x);
      }));
    const auto result = StaticFit().fit(ogden(2), curves);
    for (unsigned int j = 0; j < 4; ++j)
      EXPECT_NEAR(result.values()[j], truth[j], 1e-6);
    EXPECT_LT(result.report.rms, 1e-8);
  }

  TEST(ogden, of_exponents_2_and_minus_2_is_mooney_rivlin)
  {
    const StaticLaw law = ogden(2), mooney = incompressible_mooney_rivlin();
    for (const RigMode mode : all_modes)
      for (const double x : {.6, 1., 1.7, 3.})
        EXPECT_NEAR(law.stress(mode, x, {.4, 2., .1, -2.}),
                    mooney.stress(mode, x, {.4, .1}),
                    1e-14);
  }

  // Up to this stretch one term is all that Treloar's data ask for.
  TEST(ogden, a_term_that_vanishes_leaves_the_judgement_on_the_other)
  {
    StaticFit fit;
    fit.max_stretch = 1.6;
    const auto one  = fit.fit(ogden(1), treloar()).report,
               two  = fit.fit(ogden(2), treloar()).report;
    ASSERT_EQ(two.parameters[2].value, 0.);
    for (unsigned int j = 0; j < 2; ++j)
      EXPECT_NEAR(two.parameters[j].standard_error /
                    one.parameters[j].standard_error,
                  1.,
                  1e-5);
    EXPECT_NE(two.identifiability().find("does not feel alpha2"),
              std::string::npos)
      << two.identifiability();
  }

  // It contains Mooney-Rivlin, and one term is contained in two.
  TEST(ogden, fits_treloars_rubber_the_better_the_more_it_may)
  {
    const auto   curves = treloar();
    const double mooney =
      StaticFit().fit(incompressible_mooney_rivlin(), curves).report.rms;
    const auto one = StaticFit().fit(ogden(1), curves),
               two = StaticFit().fit(ogden(2), curves);
    EXPECT_LT(two.report.rms, one.report.rms);
    EXPECT_LT(two.report.rms, mooney);
    EXPECT_GT(two.determination, one.determination);
    // Strain hardening needs an exponent beyond that of Gaussian chains.
    EXPECT_GT(two.values()[1], 2.);
    EXPECT_LT(two.slope, 1e-6);
  }
} // namespace

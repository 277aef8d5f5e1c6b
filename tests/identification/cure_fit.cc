// SPDX-License-Identifier: LGPL-2.1-or-later
// Kinetics found from rheometer curves at several temperatures at once.
#include "identification/cure_fit.h"

#include "base/data_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
  using namespace demold;

  std::vector<RheometerCurve> natural_rubber()
  {
    std::vector<RheometerCurve> curves;
    for (const unsigned int T : {140, 160, 170})
      {
        const auto data =
          read_data_file(std::string(DEMOLD_SOURCE_DIR) +
                           "/prm/step-material/data/rheometer-" +
                           std::to_string(T) + "C.csv",
                         {{"time [s]", DataColumn::increasing},
                          {"storage torque [dNm]", DataColumn::positive}});
        curves.emplace_back(T, data.columns[0], data.columns[1]);
      }
    return curves;
  }

  // Theory A.3 and the statement of the task: 98.5 +- 3 kJ/mol.
  TEST(cure_fit, activation_energy_of_t90_of_natural_rubber)
  {
    const auto line = fit_cure_times(natural_rubber(), .9, 160.);
    EXPECT_NEAR(line.law.activation_energy, 98.5, 3.);
    EXPECT_GT(line.energy_error, 0.);
    EXPECT_LT(line.energy_error, 3.);
  }

  TEST(cure_fit, kinetics_of_three_curves_fit_within_0_02)
  {
    const auto    curves = natural_rubber();
    const CureFit fit(KamalSourour::name, curves, 160.);
    const auto    result = fit.fit();
    EXPECT_LE(result.report.rms, .02);

    // A temperature it has not seen, between those of the line through t90 and
    // its neighbours; both ways of predicting it must agree.
    const auto by_law  = fit.t90(result, 150.);
    const auto by_line = predict(fit_cure_times(curves, .9, 160.), 150.);
    EXPECT_GT(by_law.standard_error, 0.);
    EXPECT_NEAR(by_law.value, by_line.value, by_line.standard_error);
  }

  /// Curves made by a known law, with torques from 1 to 9 dNm; the last point
  /// is late enough to be the maximum.
  TEST(cure_fit, recovers_the_law_that_made_the_curves)
  {
    Kinetics truth;
    truth.law       = IsayevDeng{{1.3e-2, 96., 160.}, 2.3};
    truth.induction = {200., 94., 160.};
    std::vector<RheometerCurve> curves;
    for (const double T : {145., 160., 175.})
      {
        const double        wait = truth.induction(T);
        const double        k    = std::get<IsayevDeng>(truth.law).k(T);
        std::vector<double> times{.5 * wait, wait}, torques{1.1, 1.};
        for (unsigned int i = 1; i < 40; ++i)
          {
            times.push_back(wait + .1 * i * i / k);
            torques.push_back(1. + 8. * std::get<IsayevDeng>(truth.law)
                                          .isothermal(times.back() - wait, T));
          }
        times.push_back(wait + 1e5 / k);
        torques.push_back(9.);
        curves.emplace_back(T, times, torques);
      }
    const CureFit fit(IsayevDeng::name, curves, 160.);
    const auto    result     = fit.fit();
    const double  expected[] = {1.3e-2, 96., 2.3, 200., 94.};
    for (unsigned int i = 0; i < 5; ++i)
      EXPECT_NEAR(result.report.parameters[i].value / expected[i], 1., 1e-6);
    // 0.9 = (kx)^n/(1 + (kx)^n) gives k x = 9^(1/n)
    EXPECT_NEAR(fit.t90(result, 150.).value,
                truth.induction(150.) +
                  std::pow(9., 1. / 2.3) /
                    std::get<IsayevDeng>(truth.law).k(150.),
                1e-2);
  }
} // namespace

// SPDX-License-Identifier: LGPL-2.1-or-later
// The stability number tells beforehand whether a bond lets go in a jump.
#include "adhesion/stability_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace demold
{
  constexpr double infinity = std::numeric_limits<double>::infinity();

  // Theory D.1, its list of examples: h = 8 mm, nu = 0.495.
  TEST(stability_number, has_the_values_of_the_theory)
  {
    struct Row
    {
      double E, alpha, delta, omega, zone;
    };
    for (const Row &row : {Row{3., .2, .1, 10.7, .99},
                           Row{3., .05, .2, 1.33, 7.9},
                           Row{6., .2, .1, 5.3, 2.0},
                           Row{3., .2, .5, 2.1, 4.9},
                           Row{3., .5, .05, 53., .20}})
      {
        const auto number =
          stability_number(LinearSoftening{row.alpha, row.delta, infinity},
                           row.E,
                           .495,
                           8.);
        EXPECT_NEAR(number.omega,
                    2. * row.alpha * 8. / (row.delta * row.E),
                    1e-12 * number.omega);
        EXPECT_NEAR(number.omega / row.omega, 1., .02);
        EXPECT_NEAR(number.cohesive_zone / row.zone, 1., .02);
        EXPECT_NEAR(number.critical, 2., 1e-14);
        EXPECT_EQ(number.jumps(), row.omega > 2.);
      }
  }

  // A spring k = E/h in series with the bond: u = kappa + s(kappa)/k turns
  // back somewhere if and only if the bond jumps.
  TEST(stability_number, separates_steady_from_snapping_series_springs)
  {
    for (const Softening &softening :
         {Softening(LinearSoftening{.2, .1, 20.}),
          Softening(ExponentialSoftening{.2, .1, 20.})})
      {
        const double critical =
          stability_number(softening, 1., 0., 1.).critical;
        for (const double part : {.95, 1.05})
          {
            // Omega is inversely proportional to the modulus.
            const double modulus =
              stability_number(softening, 1., 0., 1.).omega / (part * critical);
            const bool turns_back = std::visit(
              [&](const auto &law) {
                const auto u = [&](const double kappa) {
                  return kappa + law.on_curve(kappa).limit / modulus;
                };
                const double at = law.onset_gap();
                return u(at * (1. + 1e-6)) < u(at);
              },
              softening);
            EXPECT_EQ(stability_number(softening, modulus, 0., 1.).jumps(),
                      turns_back);
            EXPECT_EQ(turns_back, part > 1.);
          }
      }
  }

  TEST(stability_number, preview_tells_the_three_cases_apart)
  {
    const Softening softening = LinearSoftening{.2, .1, infinity};
    // Omega = 32/E here with h = 8: jumps below E = 16.
    const auto text = [&](const double relaxed, const double instantaneous) {
      return stability_preview(softening, relaxed, instantaneous, .495, 8.)
        .text();
    };
    EXPECT_NE(text(3., 6.).find("in a jump at any speed"), std::string::npos);
    EXPECT_NE(text(10., 20.).find("delayed rupture"), std::string::npos);
    EXPECT_NE(text(20., 40.).find("lets go steadily"), std::string::npos);
    EXPECT_NE(text(3., 6.).find("10.7 relaxed, 5.33 instantaneous"),
              std::string::npos);
    EXPECT_NE(text(3., 6.).find("elements up to 0.331 mm"), std::string::npos);
  }
} // namespace demold

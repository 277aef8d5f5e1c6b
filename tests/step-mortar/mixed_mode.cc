// SPDX-License-Identifier: LGPL-2.1-or-later
// mixed-mode.prm: work of separation over the angle to the normal (theory
// C.4).
#include "step-mortar/run_mortar.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double energy = .5 * .2 * .1 * 100.; // G_c A [mJ]

    struct Mixing
    {
      const char *name;
      double      coupling, a, b; // beta_T; factors of theory C.2
    };

    void PrintTo(const Mixing &mixing, std::ostream *out)
    {
      *out << mixing.name;
    }

    class MixedMode : public testing::TestWithParam<Mixing>
    {};
  } // namespace

  TEST_P(MixedMode, needs_the_work_of_the_closed_form_at_every_angle)
  {
    const Mixing &mixing = GetParam();
    for (const int degree : {0, 30, 60, 90})
      {
        SCOPED_TRACE(degree);
        const double c =
          degree == 90 ? 0. : std::cos(degree * std::acos(-1.) / 180.);
        const double s    = std::sin(degree * std::acos(-1.) / 180.);
        const auto   text = [](const char *format, double x, double y = 0.) {
          char line[80];
          std::snprintf(line, sizeof(line), format, x, y);
          return std::string(line);
        };
        const SceneRun run =
          run_mortar("mixed-mode.prm",
                     {text("Supports/motion x=0.3*t*%.17g", s),
                      text("Supports/motion y=0.3*t*%.17g", c),
                      text("Process/direction=%.17g,%.17g,0", s, c),
                      std::string("Adhesion/mixing=") + mixing.name,
                      text("Adhesion/tangential coupling=%.17g",
                           mixing.coupling)});
        const double exact = energy * (c * c + mixing.a * s * s) /
                             (c * c + mixing.b * mixing.b * s * s);
        EXPECT_EQ(run.status(), "completed");
        EXPECT_EQ(run.number("bonded area left [mm^2]"), 0.);
        EXPECT_NEAR(run.number("work of demolding [mJ]"), exact, 1e-4 * exact);
        const double lost = run.number("adhesion dissipation [mJ]");
        record("dissipation at " + std::to_string(degree), lost / exact - 1.);
        EXPECT_NEAR(lost, exact, 1e-6 * exact);
      }
  }

  INSTANTIATE_TEST_SUITE_P(mixings,
                           MixedMode,
                           testing::Values(Mixing{"isotropic", 1., 1., 1.},
                                           Mixing{"slip limit", .5, .5, 1.},
                                           Mixing{"energy", .5, .25, .5},
                                           Mixing{"proportional", .5, 1., 2.}));
} // namespace demold

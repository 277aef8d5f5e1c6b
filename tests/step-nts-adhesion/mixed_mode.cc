// SPDX-License-Identifier: LGPL-2.1-or-later
// mixed-mode.prm: work of separation over the angle to the normal.
#include "step-nts-adhesion/closed_forms.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
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
    const Mixing    &mixing = GetParam();
    constexpr double area = 100., fracture_energy = .01;
    for (const int degree : {0, 15, 30, 45, 60, 75, 90})
      {
        const double angle = degree * std::acos(-1.) / 180.;
        const double c = std::cos(angle), s = std::sin(angle);
        char         text[80];
        std::snprintf(text, sizeof(text), "=0.3*t*%.17g", s);
        const std::string x = text;
        std::snprintf(text,
                      sizeof(text),
                      "=0.3*t*%.17g",
                      degree == 90 ? 0. : c);
        const std::string y = text;
        std::snprintf(text, sizeof(text), "=%.17g,%.17g,0", s, c);
        const SceneRun run =
          run_nts("mixed-mode.prm",
                  {"Supports/motion x" + x,
                   "Supports/motion y" + y,
                   std::string("Process/direction") + text,
                   std::string("Adhesion/mixing=") + mixing.name,
                   "Adhesion/tangential coupling=" +
                     std::to_string(mixing.coupling)});
        const double exact = fracture_energy * area *
                             (c * c + mixing.a * s * s) /
                             (c * c + mixing.b * mixing.b * s * s);
        EXPECT_EQ(run.number("bonded area left [mm^2]"), 0.) << degree;
        EXPECT_NEAR(run.number("work of demolding [mJ]"), exact, 1e-3 * exact)
          << degree;
        EXPECT_NEAR(run.number("adhesion dissipation [mJ]"),
                    exact,
                    1e-3 * exact)
          << degree;
      }
  }

  INSTANTIATE_TEST_SUITE_P(mixings,
                           MixedMode,
                           testing::Values(Mixing{"isotropic", 1., 1., 1.},
                                           Mixing{"slip limit", .5, .5, 1.},
                                           Mixing{"energy", .5, .25, .5},
                                           Mixing{"proportional", .5, 1., 2.}));
} // namespace demold

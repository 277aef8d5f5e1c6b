// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs of the tread block, and what its bond must lose.
#ifndef demold_tests_step_demold_demolding_h
#define demold_tests_step_demold_demolding_h

#include "run_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demold
{
  inline SceneRun run_demold(const std::string              &scene,
                             const std::vector<std::string> &overrides = {})
  {
    return run_scene(DEMOLD_STEP_DEMOLD,
                     DEMOLD_SOURCE_DIR "/prm/step-demold/" + scene,
                     overrides);
  }

  constexpr double degree = M_PI / 180.;
  constexpr double G_c    = .5 * .1 * .2; // alpha delta / 2 [mJ/mm^2]

  /// Length [mm] of the bonded line of the slice: 20 mm wide, 8 mm high,
  /// draft 3 degree, @p sipes of 0.6 mm by 6 mm with a draft of 0.5 degree.
  inline double bonded_line(const unsigned int sipes)
  {
    const double flank = 6. / std::cos(.5 * degree);
    const double tip   = .6 - 2. * 6. * std::tan(.5 * degree);
    return 20. - .6 * sipes + 2. * 8. / std::cos(3. * degree) +
           sipes * (2. * flank + tip);
  }

  /// Has let go everywhere, with a closed ledger.
  inline void expect_clean_release(const SceneRun &run)
  {
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.status(), "completed");
    EXPECT_LE(run.number("energy balance error [-]"), .01);
    EXPECT_EQ(run.number("bonded area left [mm^2]"), 0.);
    EXPECT_GE(run.number("work of demolding [mJ]"),
              run.number("adhesion dissipation [mJ]"));
  }

  /// The slice of 20 mm thickness has lost G_c times its bonded area.
  inline void expect_energy_of_the_bond(const SceneRun    &run,
                                        const unsigned int sipes)
  {
    const double energy = G_c * bonded_line(sipes) * 20.;
    EXPECT_NEAR(run.number("adhesion dissipation [mJ]"), energy, .005 * energy);
  }
} // namespace demold

#endif

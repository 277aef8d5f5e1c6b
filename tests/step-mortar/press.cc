// SPDX-License-Identifier: LGPL-2.1-or-later
// press.prm of step-nts-adhesion by mortar: forces balance.
#include "step-mortar/run_mortar.h"

#include <gtest/gtest.h>

namespace demold
{
  TEST(MortarPress, carries_the_force_of_the_grip_with_and_without_friction)
  {
    for (const char *friction : {"0", "0.3"})
      {
        const SceneRun run =
          run_scene(DEMOLD_STEP_MORTAR,
                    DEMOLD_SOURCE_DIR "/prm/step-nts-adhesion/press.prm",
                    {"Contact/formulation=mortar",
                     std::string("Friction/coefficient=") + friction});
        EXPECT_EQ(run.status(), "completed") << friction;
        double force = 0.;
        for (const double f : run.interface["force z [N]"])
          force += f;
        EXPECT_NEAR(force,
                    run.number("force at end [N]"),
                    1e-4 * std::abs(force))
          << friction;
      }
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// The scenes of step-nts-adhesion as their user runs them.
#ifndef demold_tests_step_nts_adhesion_run_nts_h
#define demold_tests_step_nts_adhesion_run_nts_h

#include "closed_forms.h"
#include "run_scene.h"

namespace demold
{
  inline SceneRun run_nts(const std::string              &scene,
                          const std::vector<std::string> &overrides = {})
  {
    return run_scene(DEMOLD_STEP_NTS_ADHESION,
                     DEMOLD_SOURCE_DIR "/prm/step-nts-adhesion/" + scene,
                     overrides);
  }
} // namespace demold

#endif

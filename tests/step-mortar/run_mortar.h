// SPDX-License-Identifier: LGPL-2.1-or-later
// The scenes of step-mortar as their user runs them.
#ifndef demold_tests_step_mortar_run_mortar_h
#define demold_tests_step_mortar_run_mortar_h

#include "closed_forms.h"
#include "run_scene.h"

namespace demold
{
  using Entries = std::vector<std::string>;

  inline Entries operator+(Entries a, const Entries &b)
  {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  inline SceneRun run_mortar(const std::string &scene,
                             const Entries     &overrides = {})
  {
    return run_scene(DEMOLD_STEP_MORTAR,
                     DEMOLD_SOURCE_DIR "/prm/step-mortar/" + scene,
                     overrides);
  }

  /// The same scene by node to segment.
  inline SceneRun run_node_to_segment(const std::string &scene,
                                      const Entries     &overrides = {})
  {
    return run_mortar(scene,
                      overrides +
                        Entries{"Contact/formulation=node to segment"});
  }

  /// Standard or dual multipliers.
  class Multipliers : public testing::TestWithParam<std::string>
  {
  protected:
    SceneRun run(const std::string &scene, const Entries &overrides = {}) const
    {
      return run_mortar(scene,
                        overrides +
                          Entries{"Contact/multipliers=" + GetParam()});
    }
  };

  /// Traction on the slave per reference area [MPa] of all points, along "x",
  /// "y" or "z".
  inline std::vector<double> traction(const SceneRun    &run,
                                      const std::string &along)
  {
    std::vector<double> result = run.interface["force " + along + " [N]"];
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] /= run.interface["area [mm^2]"][i];
    return result;
  }

  /// Largest deviation from @p exact [-].
  inline double deviation(const std::vector<double> &values, const double exact)
  {
    double worst = 0.;
    for (const double value : values)
      worst = std::max(worst, std::abs(value / exact - 1.));
    return worst;
  }

  /// Largest absolute value.
  inline double largest(const std::vector<double> &values)
  {
    double result = 0.;
    for (const double value : values)
      result = std::max(result, std::abs(value));
    return result;
  }
} // namespace demold

#endif

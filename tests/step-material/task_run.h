// SPDX-License-Identifier: LGPL-2.1-or-later
// A task of step-material run as its user would, and what it has left behind.
#ifndef demold_tests_step_material_task_run_h
#define demold_tests_step_material_task_run_h

#include "run_scene.h"

namespace demold
{
  /// @p name in the folder of the shipped scenes of step-material.
  inline std::string shipped(const std::string &name)
  {
    return DEMOLD_SOURCE_DIR "/prm/step-material/" + name;
  }

  /// The output folder lives as long as this does.
  class TaskRun
  {
  public:
    /// Runs @p scene with `--set` for each of @p overrides; throws with the
    /// words of the program where that fails.
    TaskRun(const std::string              &scene,
            const std::vector<std::string> &overrides = {})
    {
      std::vector<std::string> command = {DEMOLD_STEP_MATERIAL,
                                          scene,
                                          "--quiet",
                                          "--output",
                                          file("")};
      for (const auto &entry : overrides)
        {
          command.emplace_back("--set");
          command.push_back(entry);
        }
      if (run_command(command, folder / "log") != 0)
        throw std::runtime_error(scene + ": " + folder.read("log"));
      summary = nlohmann::json::parse(folder.read("out/summary.json"));
    }

    /// Of summary.json.
    double number(const std::string &key) const
    {
      return summary.at(key).get<double>();
    }

    std::string words(const std::string &key) const
    {
      return summary.at(key).get<std::string>();
    }

    CsvTable table(const std::string &name) const
    {
      return read_csv(folder.read("out/" + name));
    }

    /// Full name of a file of the output folder.
    std::string file(const std::string &name) const
    {
      return folder / ("out/" + name);
    }

  private:
    const ScratchFolder folder;
    nlohmann::json      summary;
  };
} // namespace demold

#endif

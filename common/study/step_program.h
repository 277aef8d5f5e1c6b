// SPDX-License-Identifier: LGPL-2.1-or-later
// The program of a step, asked what it would do with a scene.
#ifndef demold_study_step_program_h
#define demold_study_step_program_h

#include "study/sweep.h"

#include <string>
#include <utility>
#include <vector>

namespace demold
{
  struct StudyParameters;

  /// (path, value) of entries, in order.
  using Settings = std::vector<std::pair<std::string, std::string>>;

  /// The entries in the prm text of @p text, which has no includes: what
  /// `--print` prints and parameters-used.prm holds.
  Settings settings_in(const std::string &text);

  /// One scene and the program that runs it.
  class StepProgram
  {
  public:
    /// Finds the program: the one the study names, or @p programs/STEP/STEP
    /// with the step of the scene's folder. Asks it for the entries of the
    /// scene. Throws ExcParameter if there is no such program or scene, or if
    /// the study sets entries that the scene does not have.
    StepProgram(const StudyParameters &study, const std::string &programs);

    /// Throws ExcParameter if the step refuses every one of @p combinations:
    /// then it is the study that is wrong.
    void check(const std::vector<Combination> &combinations) const;

    /// The command of a run with output in @p folder.
    std::vector<std::string> command(const Combination &values,
                                     const std::string &folder) const;

    /// All entries of a run as it would use them; empty if it is refused.
    Settings settings_used(const Combination &values) const;

    const std::string &file() const;

  private:
    std::vector<std::string> call(const Combination &values) const;

    void check_entries(const StudyParameters &study);

    std::string        program;
    std::string        scene;
    std::vector<Sweep> sweeps;
    Settings           fixed; ///< for all runs
  };
} // namespace demold

#endif

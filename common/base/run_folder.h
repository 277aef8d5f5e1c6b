// SPDX-License-Identifier: LGPL-2.1-or-later
// The output folder and the checkpoint of a run, made ready before it starts.
#ifndef demold_base_run_folder_h
#define demold_base_run_folder_h

#include <string>

namespace demold
{
  struct CommandLine;
  struct RunContext;

  /// The folders @p command asks for. Throws ExcParameter when there is no
  /// checkpoint to restart from. Writes nothing.
  RunContext run_context(const CommandLine &command);

  /// Makes the output folder and writes parameters-used.prm; removes what an
  /// earlier run left that would be mistaken for results of this one. @p
  /// program is named in the file, so that ./demold finds the step again.
  /// Throws ExcParameter when the folder cannot be written to.
  void prepare_output(const RunContext &context, const std::string &program);
} // namespace demold

#endif

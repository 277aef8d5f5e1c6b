// SPDX-License-Identifier: LGPL-2.1-or-later
// The output folder and the checkpoint of a run, made ready before it starts.
#include "base/run_folder.h"

#include "base/command_line.h"
#include "base/parameter_error.h"
#include "base/run_step.h"

#include <filesystem>
#include <fstream>

namespace demold
{
  namespace fs = std::filesystem;

  RunContext run_context(const CommandLine &command)
  {
    RunContext context;
    context.scene = command.scene;
    context.quiet = command.quiet;
    context.output_folder =
      command.output.empty() ?
        (fs::path("results") / fs::path(command.scene).stem()).string() :
        command.output;

    if (!command.restart.empty())
      {
        // The folder of the run and its checkpoint/ are both understood.
        fs::path given(command.restart);
        if (!given.has_filename()) // "results/pull/"
          given = given.parent_path();
        const bool     is_checkpoint = given.filename() == "checkpoint";
        const fs::path checkpoint =
          is_checkpoint ? given : given / "checkpoint";
        context.restart_folder = checkpoint.string();
        context.restart_output = checkpoint.parent_path().string();
        if (context.restart_output.empty())
          context.restart_output = ".";
        if (!fs::is_directory(checkpoint) || fs::is_empty(checkpoint))
          throw ExcParameter("--restart",
                             "there is no checkpoint in \"" + command.restart +
                               "\".");
      }
    return context;
  }



  void prepare_output(const RunContext &context, const std::string &program)
  {
    const fs::path  folder = context.output_folder;
    const fs::path  file   = folder / "parameters-used.prm";
    std::error_code error;
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder, error))
      throw ExcParameter("--output",
                         "cannot make the folder \"" + folder.string() +
                           "\". Choose another with --output DIR.");

    // Only a folder with our mark may be tidied: it could be anyone's.
    if (fs::exists(file, error))
      {
        fs::remove(folder / "summary.json", error);
        if (context.restart_folder.empty())
          fs::remove_all(folder / "checkpoint", error);
      }

    std::ofstream out(file);
    out << "# Step : " << program << "\n# Scene: " << context.scene
        << ", every entry as used\n"
        << context.parameters_used << std::flush;
    if (!out)
      throw ExcParameter("--output",
                         "cannot write to the folder \"" + folder.string() +
                           "\". Choose another with --output DIR.");
  }
} // namespace demold

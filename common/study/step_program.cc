// SPDX-License-Identifier: LGPL-2.1-or-later
// The program of a step, asked what it would do with a scene.
#include "study/step_program.h"

#include "base/nearest_names.h"
#include "base/parameter_error.h"
#include "base/parameter_file.h"
#include "study/child_process.h"
#include "study/study_parameters.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace demold
{
  namespace
  {
    namespace fs = std::filesystem;

    /// What ./demold run does: the folder of the scene, or the note in a file
    /// that a step has printed.
    std::string step_of(const std::string &scene)
    {
      std::string step;
      for (const auto &part : fs::weakly_canonical(scene).parent_path())
        if (part.string().rfind("step-", 0) == 0)
          step = part.string();
      std::ifstream in(scene);
      for (std::string line; step.empty() && std::getline(in, line);)
        if (line.rfind("# Step", 0) == 0 && line.find(':') != std::string::npos)
          step = trimmed(line.substr(line.find(':') + 1));
      return step.empty() ? "step-demold" : step;
    }



    std::string find_program(const StudyParameters &study,
                             const std::string     &programs)
    {
      const std::string step =
        study.step.empty() ? step_of(study.scene) : study.step;
      const std::string file = study.program.empty() ?
                                 (fs::path(programs) / step / step).string() :
                                 fs::absolute(study.program).string();
      if (access(file.c_str(), X_OK) != 0 || fs::is_directory(file))
        throw ExcParameter(study.program.empty() ? "step" : "program file",
                           "must be a program that can be run; there is none "
                           "at " +
                             file + ". ./demold build makes all steps.");
      return file;
    }



    /// What a program had to say, in one line.
    std::string complaint(const ChildOutput &output)
    {
      std::string text = trimmed(output.err.empty() ? output.out : output.err);
      if (text.rfind("Bad input: ", 0) == 0)
        text = text.substr(11);
      std::replace(text.begin(), text.end(), '\n', ' ');
      return text.empty() ? "no explanation, exit code " +
                              std::to_string(output.end.exit_code) :
                            text;
    }



    bool succeeded(const ChildOutput &output)
    {
      return output.end.exit_code == 0 && output.end.signal == 0;
    }
  } // namespace



  Settings settings_in(const std::string &text)
  {
    Settings                 settings;
    std::vector<std::string> sections;
    std::istringstream       in(text);
    for (std::string line; std::getline(in, line);)
      {
        line = trimmed(line.substr(0, line.find('#')));
        if (line.rfind("subsection ", 0) == 0)
          sections.push_back(trimmed(line.substr(11)));
        else if (line == "end" && !sections.empty())
          sections.pop_back();
        else if (line.rfind("set ", 0) == 0)
          {
            const auto equals = line.find('=');
            auto       path   = sections;
            path.push_back(trimmed(line.substr(4, equals - 4)));
            settings.emplace_back(joined_path(path),
                                  equals == std::string::npos ?
                                    "" :
                                    trimmed(line.substr(equals + 1)));
          }
      }
    return settings;
  }



  StepProgram::StepProgram(const StudyParameters &study,
                           const std::string     &programs)
    : scene(study.scene)
    , sweeps(study.sweeps())
    , fixed(study.fixed_settings())
  {
    if (!fs::is_regular_file(scene))
      throw ExcParameter("scene file",
                         "must be a scene; there is no file \"" + scene +
                           "\", neither beside the study file nor in the "
                           "working directory.");
    program = find_program(study, programs);
    check_entries(study);
  }



  void StepProgram::check_entries(const StudyParameters &study)
  {
    const ChildOutput printed = output_of({program, scene, "--print"});
    if (!succeeded(printed))
      throw ExcParameter("scene file",
                         "must be a scene that " + program +
                           " can run; it says: " + complaint(printed));
    std::vector<std::string> known;
    for (const auto &setting : settings_in(printed.out))
      known.push_back(setting.first);
    const auto require = [&](const std::string &entry,
                             const std::string &path) {
      if (std::find(known.begin(), known.end(), entry) == known.end())
        throw ExcParameter(path,
                           "must be an entry of the scene; got \"" + entry +
                             "\". " + nearest_names_sentence(entry, known));
    };
    for (const Sweep &sweep : sweeps)
      require(sweep.entry, sweep.section + "/entry");
    for (const auto &setting : fixed)
      require(setting.first, "settings");

    if (!study.fields)
      for (const std::string entry :
           {"Output/fields every", "Output/checkpoint every"})
        if (std::find(known.begin(), known.end(), entry) != known.end())
          fixed.insert(fixed.begin(), {entry, "0"});
  }



  void StepProgram::check(const std::vector<Combination> &combinations) const
  {
    std::string first;
    for (const auto &values : combinations)
      {
        auto command = call(values);
        command.emplace_back("--print");
        const ChildOutput output = output_of(command);
        if (succeeded(output))
          return;
        if (first.empty())
          first = combination_text(sweeps, values) + ": " + complaint(output);
      }
    throw ExcParameter(
      sweeps.front().section,
      "every run of the study is refused, the first one with " + first);
  }



  std::vector<std::string> StepProgram::call(const Combination &values) const
  {
    std::vector<std::string> words = {program, scene};
    const auto               set   = [&words](const std::string &path,
                              const std::string &value) {
      words.emplace_back("--set");
      words.push_back(path + "=" + value);
    };
    for (const auto &[path, value] : fixed)
      set(path, value);
    for (std::size_t s = 0; s < sweeps.size(); ++s)
      set(sweeps[s].entry, values[s]);
    return words;
  }



  std::vector<std::string> StepProgram::command(const Combination &values,
                                                const std::string &folder) const
  {
    auto words = call(values);
    for (const std::string &word :
         {std::string("--quiet"), std::string("--output"), folder})
      words.push_back(word);
    return words;
  }



  Settings StepProgram::settings_used(const Combination &values) const
  {
    auto words = call(values);
    words.emplace_back("--print");
    const ChildOutput output = output_of(words);
    return succeeded(output) ? settings_in(output.out) : Settings();
  }



  const std::string &StepProgram::file() const
  {
    return program;
  }
} // namespace demold

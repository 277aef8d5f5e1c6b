// SPDX-License-Identifier: LGPL-2.1-or-later
// A step run as a child process, and what it has left behind.
#ifndef demold_tests_run_scene_h
#define demold_tests_run_scene_h

#include "scratch_folder.h"

#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include <fcntl.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace demold
{
  /// A csv file by its columns. Empty cells and words are nan.
  struct CsvTable
  {
    std::map<std::string, std::vector<double>> columns;

    const std::vector<double> &operator[](const std::string &name) const
    {
      const auto found = columns.find(name);
      if (found == columns.end())
        throw std::runtime_error("no column \"" + name + "\"");
      return found->second;
    }

    std::size_t n_rows() const
    {
      return columns.empty() ? 0 : columns.begin()->second.size();
    }
  };

  inline CsvTable read_csv(const std::string &text)
  {
    const auto cells = [](const std::string &line) {
      std::vector<std::string> list;
      std::istringstream       in(line + ',');
      for (std::string cell; std::getline(in, cell, ',');)
        list.push_back(cell);
      return list;
    };
    std::istringstream in(text);
    std::string        line;
    std::getline(in, line);
    const auto names = cells(line);
    CsvTable   table;
    for (const auto &name : names)
      table.columns[name];
    while (std::getline(in, line))
      {
        const auto row = cells(line);
        for (std::size_t k = 0; k < names.size(); ++k)
          {
            char        *end   = nullptr;
            const char  *begin = row.at(k).c_str();
            const double value = std::strtod(begin, &end);
            table.columns[names[k]].push_back(
              end == begin || *end != '\0' ? std::nan("") : value);
          }
      }
    return table;
  }

  struct SceneRun
  {
    int            exit_code = -1;
    nlohmann::json summary;
    CsvTable       history;   ///< a row per accepted increment
    CsvTable       interface; ///< a row per slave point, at the end

    double number(const std::string &key) const
    {
      return summary.at(key).get<double>();
    }

    std::string status() const
    {
      return summary.at("status").get<std::string>();
    }
  };

  /// Runs @p command (no shell) with its words written to @p log; returns its
  /// exit code.
  inline int run_command(const std::vector<std::string> &command,
                         const std::string              &log)
  {
    const pid_t child = fork();
    if (child == 0)
      {
        std::vector<char *> arguments;
        for (const auto &word : command)
          arguments.push_back(const_cast<char *>(word.c_str()));
        arguments.push_back(nullptr);
        const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
        dup2(out, 1);
        dup2(out, 2);
        execv(arguments[0], arguments.data());
        _exit(127);
      }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// Runs @p program on @p scene with `--set` for each of @p overrides. No
  /// fields, no checkpoints unless they ask for them. Throws with the
  /// program's words if there is no summary.
  inline SceneRun run_scene(const std::string              &program,
                            const std::string              &scene,
                            const std::vector<std::string> &overrides = {})
  {
    const ScratchFolder      folder;
    std::vector<std::string> command = {program,
                                        scene,
                                        "--quiet",
                                        "--output",
                                        folder / "out",
                                        "--set",
                                        "Output/fields every=0",
                                        "--set",
                                        "Output/checkpoint every=0"};
    for (const auto &entry : overrides)
      {
        command.emplace_back("--set");
        command.push_back(entry);
      }
    SceneRun run;
    run.exit_code = run_command(command, folder / "log");
    if (!std::filesystem::exists(folder / "out/summary.json"))
      throw std::runtime_error(scene + " left no summary, exit code " +
                               std::to_string(run.exit_code) + ":\n" +
                               folder.read("log"));
    run.summary   = nlohmann::json::parse(folder.read("out/summary.json"));
    run.history   = read_csv(folder.read("out/history.csv"));
    run.interface = read_csv(folder.read("out/interface.csv"));
    return run;
  }
} // namespace demold

#endif

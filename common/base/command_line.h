// SPDX-License-Identifier: LGPL-2.1-or-later
// The options every step understands.
#ifndef demold_base_command_line_h
#define demold_base_command_line_h

#include <string>
#include <utility>
#include <vector>

namespace demold
{
  /// What the user typed.
  struct CommandLine
  {
    std::string scene; ///< parameter file
    /// (path, value) of every --set, in order.
    std::vector<std::pair<std::string, std::string>> overrides;
    std::string output;  ///< folder; empty: results/SCENE
    std::string restart; ///< folder of an earlier run; empty: from the start
    bool        check = false;
    bool        print = false;
    bool        quiet = false;
    bool        help  = false;
  };

  /// Reads @p arguments (without the program's name). Options may stand before
  /// or after the scene, their values after a blank or '='. Throws ExcParameter
  /// for what is not known or lacks its value.
  CommandLine read_command_line(const std::vector<std::string> &arguments);

  /// The text of --help.
  std::string usage(const std::string &program);
} // namespace demold

#endif

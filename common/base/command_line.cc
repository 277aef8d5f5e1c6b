// SPDX-License-Identifier: LGPL-2.1-or-later
// The options every step understands.
#include "base/command_line.h"

#include "base/nearest_names.h"
#include "base/parameter_error.h"
#include "base/parameter_file.h"

#include <algorithm>

namespace demold
{
  namespace
  {
    const std::vector<std::string> &option_names()
    {
      static const std::vector<std::string> names = {"--set",
                                                     "--output",
                                                     "--restart",
                                                     "--check",
                                                     "--print",
                                                     "--quiet",
                                                     "--help"};
      return names;
    }



    std::pair<std::string, std::string> override_from(const std::string &text)
    {
      const auto equals = text.find('=');
      if (equals == std::string::npos || trimmed(text.substr(0, equals)) == "")
        throw ExcParameter("--set",
                           "needs \"Section/Sub/entry=value\", got \"" + text +
                             "\".");
      if (text.find_first_of("#\n") != std::string::npos)
        throw ExcParameter(
          "--set",
          "a value cannot contain \"#\" or a new line, got \"" + text + "\".");

      std::string path = text.substr(0, equals);
      std::string clean; // "A / b" means "A/b"
      for (std::size_t begin = 0; begin <= path.size();)
        {
          const auto end = std::min(path.find('/', begin), path.size());
          clean +=
            (begin == 0 ? "" : "/") + trimmed(path.substr(begin, end - begin));
          begin = end + 1;
        }
      return {clean, trimmed(text.substr(equals + 1))};
    }



    /// Options that stand alone. Returns whether @p name is one.
    bool set_switch(CommandLine &command, const std::string &name)
    {
      if (name == "--check")
        command.check = true;
      else if (name == "--print")
        command.print = true;
      else if (name == "--quiet")
        command.quiet = true;
      else if (name == "--help" || name == "-h")
        command.help = true;
      else
        return false;
      return true;
    }



    void set_option(CommandLine       &command,
                    const std::string &name,
                    const std::string &value)
    {
      if (name == "--set")
        command.overrides.push_back(override_from(value));
      else if (value.empty())
        throw ExcParameter(name, "needs the name of a folder.");
      else if (name == "--output")
        command.output = value;
      else
        command.restart = value;
    }
  } // namespace



  CommandLine read_command_line(const std::vector<std::string> &arguments)
  {
    CommandLine command;
    for (std::size_t i = 0; i < arguments.size(); ++i)
      {
        const std::string &argument = arguments[i];
        if (argument.empty() || argument[0] != '-')
          {
            if (!command.scene.empty())
              throw ExcParameter(argument,
                                 "one parameter file at a time; \"" +
                                   command.scene + "\" is given already.");
            if (argument.empty())
              throw ExcParameter("SCENE.prm", "the name is empty.");
            command.scene = argument;
            continue;
          }

        if (set_switch(command, argument))
          continue;

        const auto        equals = argument.find('=');
        const std::string name   = argument.substr(0, equals);
        if (name != "--set" && name != "--output" && name != "--restart")
          throw ExcParameter(argument,
                             "there is no such option. " +
                               nearest_names_sentence(name, option_names()));
        if (equals != std::string::npos)
          set_option(command, name, argument.substr(equals + 1));
        else if (++i < arguments.size())
          set_option(command, name, arguments[i]);
        else
          throw ExcParameter(name,
                             name == "--set" ?
                               "needs \"Section/Sub/entry=value\" after it." :
                               "needs the name of a folder after it.");
      }
    return command;
  }



  std::string usage(const std::string &program)
  {
    return "Usage: " + program +
           " SCENE.prm [options]\n"
           "  without arguments   print the parameter file with all defaults\n"
           "  --set \"Section/Sub/entry=value\"\n"
           "                      override an entry; may be repeated\n"
           "  --output DIR        folder for results, default results/SCENE\n"
           "  --restart DIR       go on from the checkpoint in DIR, the folder\n"
           "                      of an earlier run\n"
           "  --check             read and check, say what would be "
           "simulated,\n"
           "                      compute and write nothing\n"
           "  --print             print every entry as it would be used\n"
           "  --quiet             nothing on the console but errors\n"
           "  -h, --help          this text\n"
           "Exit codes: 0 completed, 1 gave up or was stopped, 2 bad input\n";
  }
} // namespace demold

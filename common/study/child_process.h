// SPDX-License-Identifier: LGPL-2.1-or-later
// Programs run as children: started, watched, stopped.
#ifndef demold_study_child_process_h
#define demold_study_child_process_h

#include <sys/types.h>

#include <string>
#include <vector>

namespace demold
{
  /// How a child ended.
  struct ChildEnd
  {
    int    exit_code = 0;
    int    signal    = 0;  ///< that killed it; 0: none did
    double cpu_time  = 0.; ///< user and system, its own children included [s]
  };

  /// What a short program has written until it ended.
  struct ChildOutput
  {
    ChildEnd    end;
    std::string out;
    std::string err;
  };

  /// Starts @p command (no shell; exit code 127 if it cannot be) with both its
  /// outputs in the file @p log. It gets SIGTERM if we die, and is in a process
  /// group of its own: Ctrl-C reaches it through us. Throws std::runtime_error.
  pid_t start_child(const std::vector<std::string> &command,
                    const std::string              &log);

  /// Whether @p child has ended, and how. Does not wait.
  bool has_ended(const pid_t child, ChildEnd &end);

  /// Sends SIGTERM to all, and SIGKILL to those that still run @p patience [s]
  /// later. Returns when all have ended.
  void stop_children(const std::vector<pid_t> &children, const double patience);

  /// Runs @p command to its end. Throws std::runtime_error.
  ChildOutput output_of(const std::vector<std::string> &command);
} // namespace demold

#endif

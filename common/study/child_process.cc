// SPDX-License-Identifier: LGPL-2.1-or-later
// Programs run as children: started, watched, stopped.
#include "study/child_process.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <thread>

namespace demold
{
  namespace
  {
    using File = std::unique_ptr<std::FILE, int (*)(std::FILE *)>;

    constexpr int cannot_start = 127;

    /// Forks; the child writes into the two descriptors.
    pid_t spawn(const std::vector<std::string> &command,
                const int                       out,
                const int                       err)
    {
      std::vector<char *> arguments;
      for (const auto &word : command)
        arguments.push_back(const_cast<char *>(word.c_str()));
      arguments.push_back(nullptr);

      const pid_t parent = getpid();
      const pid_t child  = fork();
      if (child < 0)
        throw std::runtime_error("cannot start another process: too many run "
                                 "already, or too little memory is left.");
      if (child > 0)
        return child;

      // Only calls that are safe after fork.
      setpgid(0, 0);
      prctl(PR_SET_PDEATHSIG, SIGTERM);
      if (getppid() != parent) // it died before prctl
        _exit(cannot_start);
      const int nothing = open("/dev/null", O_RDONLY);
      dup2(nothing, STDIN_FILENO);
      dup2(out, STDOUT_FILENO);
      dup2(err, STDERR_FILENO);
      execv(arguments[0], arguments.data());
      _exit(cannot_start);
    }



    ChildEnd end_of(const int status, const rusage &usage)
    {
      const auto seconds = [](const timeval &t) {
        return t.tv_sec + 1e-6 * t.tv_usec;
      };
      ChildEnd end;
      end.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
      end.signal    = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
      end.cpu_time  = seconds(usage.ru_utime) + seconds(usage.ru_stime);
      return end;
    }



    File scratch_file()
    {
      File file(std::tmpfile(), &std::fclose);
      if (!file)
        throw std::runtime_error("cannot write a temporary file. Is the disk "
                                 "full?");
      fcntl(fileno(file.get()), F_SETFD, FD_CLOEXEC);
      return file;
    }



    std::string content(std::FILE *file)
    {
      std::string text;
      char        part[4096];
      std::rewind(file);
      while (const auto n = std::fread(part, 1, sizeof(part), file))
        text.append(part, n);
      return text;
    }
  } // namespace



  pid_t start_child(const std::vector<std::string> &command,
                    const std::string              &log)
  {
    const int file =
      open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (file < 0)
      throw std::runtime_error("cannot write \"" + log +
                               "\". Is the disk full?");
    const pid_t child = spawn(command, file, file);
    close(file);
    return child;
  }



  bool has_ended(const pid_t child, ChildEnd &end)
  {
    int         status = 0;
    rusage      usage  = {};
    const pid_t ended  = wait4(child, &status, WNOHANG, &usage);
    if (ended == child)
      end = end_of(status, usage);
    return ended == child;
  }



  void stop_children(const std::vector<pid_t> &children, const double patience)
  {
    using clock = std::chrono::steady_clock;
    const auto deadline =
      clock::now() + std::chrono::duration<double>(patience);
    std::vector<pid_t> left = children;
    for (const pid_t child : left)
      kill(child, SIGTERM);
    bool killed = false;
    while (!left.empty())
      {
        std::vector<pid_t> running;
        ChildEnd           end;
        for (const pid_t child : left)
          if (!has_ended(child, end))
            running.push_back(child);
        left = running;
        if (!killed && clock::now() > deadline)
          {
            for (const pid_t child : left)
              kill(-child, SIGKILL); // with what it has started itself
            killed = true;
          }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      }
  }



  ChildOutput output_of(const std::vector<std::string> &command)
  {
    const File  out = scratch_file(), err = scratch_file();
    const pid_t child  = spawn(command, fileno(out.get()), fileno(err.get()));
    int         status = 0;
    rusage      usage  = {};
    pid_t       ended;
    do
      ended = wait4(child, &status, 0, &usage);
    while (ended < 0 && errno == EINTR);
    return {end_of(status, usage), content(out.get()), content(err.get())};
  }
} // namespace demold

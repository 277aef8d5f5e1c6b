// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures of history.csv, drawn by gnuplot from scripts the user keeps.
#include "output/plots.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace demold
{
  namespace
  {
    namespace fs = std::filesystem;

    /// A text as gnuplot reads it between double quotes.
    std::string quoted(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : text)
        result +=
          (c == '"' || c == '\\') ? std::string{'\\', c} : std::string(1, c);
      return result + "\"";
    }



    enum class Outcome
    {
      drawn,
      failed,
      no_gnuplot
    };



    /// Runs gnuplot on @p script in @p folder, without a shell: names may
    /// contain anything.
    Outcome run_gnuplot(const std::string &folder, const std::string &script)
    {
      posix_spawn_file_actions_t actions;
      posix_spawn_file_actions_init(&actions);
      posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
      for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&actions,
                                         stream,
                                         "/dev/null",
                                         O_RDWR,
                                         0);

      std::string name = "gnuplot", file = script;
      char *const arguments[] = {name.data(), file.data(), nullptr};
      pid_t       child;
      const int   error = posix_spawnp(&child,
                                     name.c_str(),
                                     &actions,
                                     nullptr,
                                     arguments,
                                     environ);
      posix_spawn_file_actions_destroy(&actions);
      if (error != 0)
        return error == ENOENT ? Outcome::no_gnuplot : Outcome::failed;

      int   status = 0;
      pid_t ended;
      do
        ended = waitpid(child, &status, 0);
      while (ended < 0 && errno == EINTR);
      const bool well = ended == child && WIFEXITED(status);
      return well && WEXITSTATUS(status) == 0 ? Outcome::drawn :
                                                Outcome::failed;
    }
  } // namespace



  std::string plot_head(const std::string &name, const std::string &title)
  {
    std::ostringstream script;
    script << "# Draw again with: gnuplot " << name << ".gp\n"
           << "set terminal svg size 800,500 noenhanced font 'sans,14' "
              "background 'white'\n"
           << "set output 'plots/" << name << ".svg'\n"
           << "set title " << quoted(title) << "\n"
           << "set grid linecolor rgb '#d0d0d0'\n"
           << "set border linecolor rgb '#404040'\n";
    // Okabe and Ito's: colour-blind readers can tell them apart.
    const char *const colours[] = {"#0072b2",
                                   "#d55e00",
                                   "#009e73",
                                   "#cc79a7",
                                   "#e69f00",
                                   "#56b4e9",
                                   "#000000",
                                   "#8c6d1f",
                                   "#7f7f7f"};
    unsigned int      n         = 0;
    for (const char *const colour : colours)
      script << "set linetype " << ++n << " linewidth 2 linecolor rgb '"
             << colour << "'\n";
    return script.str();
  }



  std::string plot_script(const LinePlot &plot)
  {
    std::ostringstream script;
    script << plot_head(plot.name, plot.title)
           << "set datafile separator comma\n"
           << "set xlabel " << quoted(plot.x) << "\n"
           << "set ylabel " << quoted(plot.y_label) << "\n"
           << (plot.y.size() > 1 ? "set key below\n" : "set key off\n")
           << "plot ";
    for (std::size_t i = 0; i < plot.y.size(); ++i)
      script << (i == 0 ? "" : ", \\\n     ")
             << (i == 0 ? "'history.csv'" : "''") << " using (column("
             << quoted(plot.x) << ")):(column(" << quoted(plot.y[i])
             << ")) with lines title " << quoted(plot.y[i]);
    script << "\n";
    return script.str();
  }



  std::string plot_script(const TimeBreakdown &times)
  {
    auto sorted = times;
    std::stable_sort(sorted.begin(),
                     sorted.end(),
                     [](const auto &a, const auto &b) {
                       return a.second > b.second;
                     });
    std::ostringstream script;
    script << plot_head("time-breakdown", "Where the time goes")
           << "$times << END\n";
    for (const auto &[what, seconds] : sorted)
      script << quoted(what) << ' ' << seconds << '\n';
    script << "END\n"
           << "set ylabel 'time [s]'\n"
           << "set yrange [0:*]\n"
           << "set style fill solid 0.8\n"
           << "set boxwidth 0.6\n"
           << "set key off\n"
           << "plot $times using 0:2:xtic(1) with boxes linetype 1, \\\n"
           << "     $times using 0:2:(sprintf('%.3g', $2)) with labels "
              "offset 0,0.7\n";
    return script.str();
  }



  std::string draw_plots(const std::string           &output_folder,
                         const std::vector<LinePlot> &plots,
                         const TimeBreakdown         &times)
  {
    std::vector<std::pair<std::string, std::string>> scripts;
    for (const auto &plot : plots)
      scripts.emplace_back(plot.name + ".gp", plot_script(plot));
    if (!times.empty())
      scripts.emplace_back("time-breakdown.gp", plot_script(times));
    return draw_scripts(output_folder, scripts);
  }



  std::string
  draw_scripts(const std::string &output_folder,
               const std::vector<std::pair<std::string, std::string>> &scripts)
  {
    std::error_code error;
    fs::create_directories(fs::path(output_folder) / "plots", error);
    std::string failed;
    for (const auto &[name, text] : scripts)
      {
        const fs::path file = fs::path(output_folder) / name;
        std::ofstream(file) << text;
        const Outcome outcome = run_gnuplot(output_folder, name);
        if (outcome == Outcome::failed)
          failed += " " + name;
        if (outcome == Outcome::no_gnuplot)
          {
            for (const auto &script : scripts) // to be drawn elsewhere
              std::ofstream(fs::path(output_folder) / script.first)
                << script.second;
            return "No pictures: gnuplot is not installed. Where it is, run it "
                   "on the .gp files in " +
                   output_folder + ".";
          }
      }
    return failed.empty() ? "" :
                            "No picture from" + failed + " in " +
                              output_folder + ": run gnuplot there to see why.";
  }
} // namespace demold

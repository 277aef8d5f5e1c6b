// SPDX-License-Identifier: LGPL-2.1-or-later
// Performs the runs of a study, several at a time, and can be interrupted.
#include "study/run_queue.h"

#include "base/stop_signal.h"
#include "output/progress.h"
#include "study/child_process.h"
#include "study/step_program.h"
#include "study/study_parameters.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <thread>

namespace demold
{
  namespace
  {
    namespace fs = std::filesystem;

    /// Time a run gets to end its increment and write its checkpoint [s].
    constexpr double patience = 20.;

    class Queue
    {
    public:
      Queue(std::vector<StudyRun>   &runs,
            const std::vector<bool> &finished,
            const StepProgram       &program,
            const StudyParameters   &study,
            std::ostream            &out)
        : runs(runs)
        , program(program)
        , study(study)
        , out(out)
        , start(std::chrono::steady_clock::now())
      {
        for (std::size_t i = 0; i < runs.size(); ++i)
          if (finished[i])
            {
              report(i, "found");
              ++n_found;
            }
          else
            waiting.push_back(i);
      }

      bool perform()
      {
        while (!waiting.empty() || !active.empty())
          {
            if (stop_requested())
              {
                stop();
                return false;
              }
            while (!waiting.empty() && active.size() < study.runs_at_a_time)
              start_next();
            if (!collect())
              std::this_thread::sleep_for(std::chrono::milliseconds(20));
          }
        return true;
      }

      void stop()
      {
        std::vector<pid_t> children;
        for (const auto &child : active)
          children.push_back(child.first);
        active.clear();
        stop_children(children, patience);
      }

    private:
      void start_next()
      {
        const std::size_t i = waiting.front();
        waiting.erase(waiting.begin());
        const fs::path  folder = runs[i].folder;
        std::error_code ignored;
        fs::create_directories(folder, ignored);
        // What an earlier run has left must not pass for results of this one.
        for (const char *const file : {"summary.json", "outcome.json"})
          fs::remove(folder / file, ignored);
        active.emplace_back(start_child(program.command(runs[i].values,
                                                        folder.string()),
                                        (folder / "log.txt").string()),
                            i);
      }



      /// Has any of the active runs ended?
      bool collect()
      {
        const std::size_t before = active.size();
        for (std::size_t k = 0; k < active.size();)
          {
            ChildEnd end;
            if (!has_ended(active[k].first, end))
              {
                ++k;
                continue;
              }
            const std::size_t i = active[k].second;
            active.erase(active.begin() + k);
            if (stop_requested() && end.exit_code + end.signal != 0)
              continue; // by the same signal as we: not a result
            write_outcome(runs[i], end);
            report(i, "");
          }
        return active.size() < before;
      }



      /// Reads the results of run @p i and prints its line.
      void report(const std::size_t i, const std::string &how)
      {
        StudyRun &run = runs[i];
        read_results(run, study);
        ++n_ended;

        std::ostringstream line;
        line << '[' << n_ended << '/' << runs.size() << "] "
             << combination_text(study.sweeps(), run.values) << ": "
             << run.status;
        if (!run.completed && !run.reason.empty())
          line << " (" << run.reason << ')';
        if (std::isfinite(run.quantity))
          line << ", " << run.quantity;
        if (std::isfinite(run.cpu_time))
          line << ", " << std::setprecision(3) << run.cpu_time << " s CPU";
        if (!how.empty())
          line << ", " << how;
        else if (n_ended < runs.size())
          {
            const std::chrono::duration<double> elapsed =
              std::chrono::steady_clock::now() - start;
            const double n = runs.size();
            line << "; left: about "
                 << duration_text(
                      seconds_left(n_found / n, n_ended / n, elapsed.count()));
          }
        out << line.str() << std::endl;
      }

      std::vector<StudyRun> &runs;
      const StepProgram     &program;
      const StudyParameters &study;
      std::ostream          &out;

      std::chrono::steady_clock::time_point start;
      std::vector<std::size_t>              waiting;
      /// Process and the number of its run.
      std::vector<std::pair<pid_t, std::size_t>> active;
      unsigned int                               n_found = 0;
      unsigned int                               n_ended = 0;
    };
  } // namespace



  std::vector<bool> finished_runs(const std::vector<StudyRun> &runs,
                                  const StepProgram           &program)
  {
    std::vector<bool> finished;
    for (const StudyRun &run : runs)
      {
        bool same = false;
        if (has_results(run))
          {
            std::ostringstream used;
            used << std::ifstream(fs::path(run.folder) / "parameters-used.prm")
                      .rdbuf();
            const Settings settings = program.settings_used(run.values);
            same = !settings.empty() && settings == settings_in(used.str());
          }
        finished.push_back(same);
      }
    return finished;
  }



  bool perform_runs(std::vector<StudyRun>   &runs,
                    const std::vector<bool> &finished,
                    const StepProgram       &program,
                    const StudyParameters   &study,
                    std::ostream            &out)
  {
    Queue queue(runs, finished, program, study, out);
    try
      {
        return queue.perform();
      }
    catch (...)
      {
        queue.stop(); // no run outlives its study
        throw;
      }
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// main() of the study: reads the file, performs the runs, writes the table.
#include "study/study.h"

#include "base/command_line.h"
#include "base/parameter_entries.h"
#include "base/parameter_error.h"
#include "base/parameter_file.h"
#include "base/run_folder.h"
#include "base/run_step.h"
#include "base/stop_signal.h"
#include "output/plots.h"
#include "study/comparison.h"
#include "study/run_queue.h"
#include "study/step_program.h"
#include "study/study_parameters.h"
#include "study/study_picture.h"
#include "study/study_report.h"

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace demold
{
  using namespace dealii;

  namespace
  {
    namespace fs = std::filesystem;

    std::string study_usage()
    {
      return "Usage: study STUDY.prm [options]\n"
             "  without arguments   print the study file with all defaults\n"
             "  --set \"Section/entry=value\"\n"
             "                      override an entry of the study; may be\n"
             "                      repeated\n"
             "  --output DIR        folder for results, default results/STUDY\n"
             "  --check             show the list of runs, perform none\n"
             "  --print             print every entry as it would be used\n"
             "  --quiet             nothing on the console but errors\n"
             "  -h, --help          this text\n"
             "Runs that have been performed with the same settings are not "
             "repeated:\n"
             "an interrupted study goes on when it is called again.\n"
             "Exit codes: 0 the table is written, 1 stopped, 2 bad input\n";
    }



    /// Ctrl-C and a closed terminal ask for the same as SIGTERM.
    void catch_signals()
    {
      catch_stop_signal();
      struct sigaction action = {};
      sigaction(SIGTERM, nullptr, &action);
      sigaction(SIGINT, &action, nullptr);
      sigaction(SIGHUP, &action, nullptr);
    }



    void print_plan(const StudyParameters       &study,
                    const std::vector<StudyRun> &runs,
                    const std::vector<bool>     &finished,
                    const StepProgram           &program)
    {
      std::cout << "What will be studied: " << study.compare.quantity_in_words()
                << "\n  scene      " << study.scene << "\n  program    "
                << program.file() << "\n  reference  "
                << study.compare.reference << "\n  runs       " << runs.size()
                << ", " << study.runs_at_a_time << " at a time\n";
      for (std::size_t i = 0; i < runs.size(); ++i)
        {
          std::cout << "  " << i + 1 << ". "
                    << combination_text(study.sweeps(), runs[i].values);
          if (study.compare.reference == "closed form")
            std::cout << ", expected "
                      << evaluate_formula(study.compare.closed_form,
                                          study.symbols(runs[i].values),
                                          "Compare/closed form");
          std::cout << (finished[i] ? " (done already)\n" : "\n");
        }
      std::cout << std::flush;
    }



    void write_text(const fs::path &file, const std::string &text)
    {
      std::ofstream out(file);
      out << text << std::flush;
      if (!out)
        throw std::runtime_error("cannot write \"" + file.string() +
                                 "\". Is the disk full?");
    }



    void write_results(const StudyParameters &study,
                       std::vector<StudyRun> &runs,
                       const fs::path        &folder,
                       std::ostream          &out)
    {
      const auto         all_series = compare_runs(study, runs);
      const StudyPicture picture    = picture_of(study, runs, all_series);
      std::string        link;
      std::string        complaint =
        "No picture: no run has both an error and a time.";
      if (!picture.name.empty())
        {
          complaint = draw_scripts(folder.string(),
                                   {{picture.name + ".gp", picture.script}});
          link      = "plots/" + picture.name + ".svg";
        }
      write_csv((folder / "study.csv").string(), study, runs);
      const std::string report = report_text(study, runs, all_series, link);
      write_text(folder / "study.md", report);
      out << '\n' << report << std::flush;
      if (!complaint.empty())
        out << complaint << '\n';
      out << "Written: " << (folder / "study.csv").string() << ", study.md"
          << (complaint.empty() ? ", " + link : "") << std::endl;
    }



    void read_study(const CommandLine &command,
                    ParameterHandler  &prm,
                    StudyParameters   &study)
    {
      set_entries(prm, read_parameter_file(command.scene));
      set_entries(prm, command.overrides);
      check_mandatory_entries(prm);
      study.check();
      study.scene = fs::path(study.scene).lexically_normal().string();
      if (study.title.empty())
        study.title = fs::path(command.scene).stem().string();
    }



    void prepare_folder(const fs::path &folder, const std::string &parameters)
    {
      std::error_code error;
      fs::create_directories(folder, error);
      std::ofstream out(folder / "study-used.prm");
      out << parameters << std::flush;
      if (!out)
        throw ExcParameter("--output",
                           "cannot write to the folder \"" + folder.string() +
                             "\". Choose another with --output DIR.");
    }



    RunStatus perform(const StudyParameters &study,
                      const CommandLine     &command,
                      const std::string     &parameters,
                      const std::string     &programs)
    {
      setenv("OPENBLAS_NUM_THREADS", "1", 1); // CPU times are to be comparable
      const fs::path folder = run_context(command).output_folder;
      auto           runs   = planned_runs(study, folder.string());

      const StepProgram program(study, programs);
      program.check(combinations(study.sweeps()));
      const auto finished = finished_runs(runs, program);
      if (command.check)
        {
          print_plan(study, runs, finished, program);
          return RunStatus::completed;
        }

      std::ostream  silence(nullptr);
      std::ostream &out = command.quiet ? silence : std::cout;
      prepare_folder(folder, parameters);
      catch_signals();
      const bool all_ended = perform_runs(runs, finished, program, study, out);
      write_results(study, runs, folder, out);
      if (!all_ended)
        std::cerr << "Stopped by a signal. The same command goes on with the "
                     "runs that are left."
                  << std::endl;
      return all_ended ? RunStatus::completed : RunStatus::gave_up;
    }
  } // namespace



  int run_study(const std::vector<std::string> &arguments,
                const std::string              &programs)
  {
    RunStatus status = RunStatus::completed;
    try
      {
        const CommandLine command = read_command_line(arguments);
        StudyParameters   study;
        ParameterHandler  prm;
        study.add_parameters(prm);
        use_printed_defaults(prm);
        if (command.help)
          std::cout << study_usage();
        else if (arguments.empty())
          std::cout << parameter_text(prm) << std::flush;
        else if (command.scene.empty())
          throw ExcParameter("STUDY.prm",
                             "no study file given. Without arguments, study "
                             "prints one to start from.");
        else if (!command.restart.empty())
          throw ExcParameter("--restart",
                             "is not for studies: one that was interrupted "
                             "goes on when it is called again.");
        else
          {
            read_study(command, prm, study);
            const std::string parameters = parameter_text(prm);
            if (command.print)
              std::cout << parameters << std::flush;
            else
              status = perform(study, command, parameters, programs);
          }
      }
    catch (const ExcParameter &error)
      {
        std::cerr << "Bad input: " << error.what() << std::endl;
        status = RunStatus::bad_input;
      }
    catch (const std::exception &error)
      {
        std::cerr << "Gave up: " << error.what() << std::endl;
        status = RunStatus::gave_up;
      }
    return static_cast<int>(status);
  }
} // namespace demold

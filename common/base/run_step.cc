// SPDX-License-Identifier: LGPL-2.1-or-later
// main() of every step: command line, parameter file, MPI, errors, exit code.
#include "base/run_step.h"

#include "base/command_line.h"
#include "base/error_agreement.h"
#include "base/parameter_entries.h"
#include "base/parameter_error.h"
#include "base/parameter_file.h"
#include "base/run_folder.h"
#include "base/stop_signal.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <sstream>
#include <utility>
#include <vector>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// How an exception ends the program.
    struct Failure
    {
      RunStatus   status = RunStatus::completed;
      std::string message;
    };



    /// The exception being handled, in words. Call inside catch (...).
    Failure current_failure()
    {
      try
        {
          throw;
        }
      catch (const ExcParameter &error)
        {
          return {RunStatus::bad_input, error.what()};
        }
      catch (const ExceptionBase &error)
        {
          std::ostringstream info;
          error.print_info(info);
          const std::string call = error.get_exc_name();
          return {RunStatus::gave_up,
                  trimmed(info.str()) + " [" + call.substr(0, call.find('(')) +
                    "]"};
        }
      catch (const std::bad_alloc &)
        {
          return {RunStatus::gave_up,
                  "out of memory. A coarser mesh, an iterative linear solver "
                  "or more ranks on more machines need less."};
        }
      catch (const std::exception &error)
        {
          return {RunStatus::gave_up, error.what()};
        }
      catch (...)
        {
          return {RunStatus::gave_up, "an exception of unknown type"};
        }
    }



    /// The rank before MPI has started, from the environment mpirun sets.
    bool is_first_of_launch()
    {
      for (const char *const name :
           {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
        if (const char *const rank = std::getenv(name))
          return std::string(rank) == "0";
      return true;
    }



    void print_failure(const Failure &failure)
    {
      std::cout << std::flush;
      std::cerr << (failure.status == RunStatus::bad_input ? "Bad input: " :
                                                             "Gave up: ")
                << failure.message << std::endl;
    }



    /// A run that dies leaves a summary that says so; one that the step has
    /// already written stays.
    void write_failed_summary(const RunContext &context, const Failure &failure)
    {
      const auto file =
        std::filesystem::path(context.output_folder) / "summary.json";
      if (std::filesystem::exists(file))
        return;
      std::string reason;
      for (const char c : failure.message)
        if (c == '"' || c == '\\')
          reason += {'\\', c};
        else
          reason += (static_cast<unsigned char>(c) < ' ' ? ' ' : c);
      std::ofstream(file) << "{\n  \"status\": \"gave up\",\n  \"reason\": \""
                          << reason << "\"\n}\n";
    }



    RunStatus compute(const StepFront   &step,
                      const CommandLine &command,
                      RunContext        &context,
                      const std::string &program,
                      const bool         is_first)
    {
      const std::string preview = step.preview();
      if (is_first && !context.quiet)
        std::cout << preview << (preview.empty() ? "" : "\n") << std::flush;
      if (command.check)
        return RunStatus::completed;

      // The first rank alone writes, but all must know whether it could.
      std::string complaint;
      if (is_first)
        try
          {
            prepare_output(context, program);
          }
        catch (const ExcParameter &error)
          {
            complaint = error.what();
          }
      complaint = Utilities::MPI::broadcast(MPI_COMM_WORLD, complaint);
      if (!complaint.empty())
        {
          const auto colon = complaint.find(": ");
          throw ExcParameter(complaint.substr(0, colon),
                             complaint.substr(colon + 2));
        }

      if (!is_first)
        context.quiet = true;
      return step.run(context);
    }



    /// The half of a run that needs MPI. @p step is taken over: it must end
    /// before MPI does.
    RunStatus compute_with_mpi(StepFront          step,
                               const CommandLine &command,
                               RunContext         context,
                               int                argc,
                               char             **argv)
    {
      const std::string program = std::filesystem::path(argv[0]).filename();

      // Twice, because the libraries behind MPI_InitFinalize may take the
      // signal for themselves.
      catch_stop_signal();
      Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
      catch_stop_signal();
      const StepFront inner = std::move(step);
      ErrorAgreement  agreement(MPI_COMM_WORLD);
      const bool      is_first =
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
      if (command.check)
        context.quiet = false;

      try
        {
          return compute(inner, command, context, program, is_first);
        }
      catch (...)
        {
          const Failure failure = current_failure();
          const bool    shared  = agreement.all_ranks_failed();
          if (is_first || !shared)
            {
              print_failure(failure);
              if (failure.status == RunStatus::gave_up && !command.check)
                write_failed_summary(context, failure);
            }
          if (!shared) // the others wait for this rank and would do so for ever
            MPI_Abort(MPI_COMM_WORLD, static_cast<int>(failure.status));
          return failure.status;
        }
    }



    /// Everything that needs no MPI. Returns true when a run is to follow.
    bool read_input(const StepFront                &step,
                    const std::vector<std::string> &arguments,
                    const std::string              &program,
                    CommandLine                    &command,
                    RunContext                     &context)
    {
      const bool is_first = is_first_of_launch();
      command             = read_command_line(arguments);
      if (command.help)
        {
          if (is_first)
            std::cout << usage(program);
          return false;
        }

      ParameterHandler prm;
      step.add_parameters(prm);
      use_printed_defaults(prm);
      if (arguments.empty())
        {
          if (is_first)
            std::cout << parameter_text(prm) << std::flush;
          return false;
        }
      if (command.scene.empty())
        throw ExcParameter("SCENE.prm",
                           "no parameter file given. " + program +
                             " without arguments prints one to start from.");

      set_entries(prm, read_parameter_file(command.scene));
      set_entries(prm, command.overrides);
      check_mandatory_entries(prm);
      step.check();
      context                 = run_context(command);
      context.parameters_used = parameter_text(prm);
      if (command.print && is_first)
        std::cout << context.parameters_used << std::flush;
      return !command.print;
    }
  } // namespace



  int run_step(StepFront step, int argc, char **argv)
  {
    deal_II_exceptions::disable_abort_on_exception();
    deal_II_exceptions::suppress_stacktrace_in_exceptions();

    CommandLine command;
    RunContext  context;
    try
      {
        const std::vector<std::string> arguments(argv + 1, argv + argc);
        const std::string program = std::filesystem::path(argv[0]).filename();
        if (!read_input(step, arguments, program, command, context))
          return static_cast<int>(RunStatus::completed);
      }
    catch (...)
      {
        const Failure failure = current_failure();
        if (is_first_of_launch())
          print_failure(failure);
        return static_cast<int>(failure.status);
      }
    return static_cast<int>(
      compute_with_mpi(std::move(step), command, context, argc, argv));
  }
} // namespace demold

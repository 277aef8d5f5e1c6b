// SPDX-License-Identifier: LGPL-2.1-or-later
// main() of every step: command line, parameter file, MPI, errors, exit code.
#ifndef demold_base_run_step_h
#define demold_base_run_step_h

#include <functional>
#include <memory>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// How a run ended; the value is the exit code of the program.
  enum class RunStatus
  {
    completed = 0, ///< to the end, with or without jumps
    gave_up   = 1, ///< numerically, or stopped by SIGTERM or a full disk
    bad_input = 2  ///< nothing was computed
  };

  /// What a step is told about its run.
  struct RunContext
  {
    std::string scene;           ///< parameter file, as typed
    std::string output_folder;   ///< exists and can be written to
    std::string restart_folder;  ///< holds the checkpoint; empty: no restart
    std::string restart_output;  ///< results of the run to go on from
    std::string parameters_used; ///< text of parameters-used.prm
    bool        quiet = false;   ///< true on all ranks but the first
  };

  /// A step as the front sees it.
  struct StepFront
  {
    std::function<void(dealii::ParameterHandler &)> add_parameters;
    std::function<void()>                           check;
    std::function<std::string()>                    preview;
    std::function<RunStatus(const RunContext &)>    run;
  };

  /// Runs @p step with the arguments of main() and returns the exit code.
  int run_step(StepFront step, int argc, char **argv);

  /// A new Step, owned by the functions alone: it ends when they do.
  template <class Step>
  StepFront make_front()
  {
    const auto step = std::make_shared<Step>();
    StepFront  front;
    front.add_parameters = [step](dealii::ParameterHandler &prm) {
      step->add_parameters(prm);
    };
    front.check   = [step]() { step->check(); };
    front.preview = [step]() { return step->preview(); };
    front.run     = [step](const RunContext &context) {
      return step->run(context);
    };
    return front;
  }



  /// main() of every step. A Step is what the parameter file says and
  /// * is default constructible, without touching MPI (so it has no vectors of
  ///   Trilinos for members; run() makes those): wrong input is reported before
  ///   the second that MPI takes to start,
  /// * void add_parameters(ParameterHandler &),
  /// * void check() const: throws ExcParameter; called once all is parsed,
  /// * std::string preview() const: what will be simulated, for --check and for
  ///   the top of the console output; called on all ranks, with MPI,
  /// * RunStatus run(const RunContext &): called on all ranks.
  /// It is destroyed before MPI ends. Everything run() writes goes to
  /// output_folder, from where the front has removed the summary and, unless
  /// restarting, the checkpoint of an earlier run.
  template <class Step>
  int run_step(int argc, char **argv)
  {
    return run_step(make_front<Step>(), argc, argv);
  }
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// A network of springs, bars and bonds: from entries to records.
#include "scene/network_scene.h"

#include "base/parameter_error.h"
#include "base/stop_signal.h"
#include "scene/checkpoint.h"
#include "scene/expression.h"
#include "scene/network_system.h"
#include "scene/recorder.h"
#include "scene/run_summary.h"
#include "scene/scene_strategy.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    std::optional<AdhesionLaw> law_of(const SceneParameters &parameters)
    {
      std::optional<AdhesionLaw> law;
      if (parameters.interface.adhesion.active())
        law = parameters.interface.adhesion.law();
      return law;
    }

    /// The run loop of a network.
    class NetworkRun
    {
    public:
      NetworkRun(const NetworkEntries  &entries,
                 const SceneParameters &parameters,
                 const RunContext      &context)
        : entries(entries)
        , parameters(parameters)
        , context(context)
        , linear_solver(parameters.linear_solver_of_scene(), communicator)
        , newton(make_nonlinear_solver(parameters.newton, linear_solver))
        , system(entries, law_of(parameters), communicator)
        , recorder(context,
                   !entries.bonds.empty(),
                   parameters.strategy == "arc length")
      {}

      RunStatus run()
      {
        const Strategy strategy =
          make_strategy(parameters,
                        {*system.weak_form,
                         *newton,
                         linear_solver,
                         entries.end_time,
                         [this](const std::string &text) {
                           recorder.note(text);
                         }},
                        increment_state);
        if (!context.restart_folder.empty())
          read_checkpoint();
        return finish(strategy(
          [this](const IncrementRecord &record) { return accept(record); }));
      }

    private:
      bool accept(const IncrementRecord &record)
      {
        recorder.record(system.observe(record));
        ++increments;
        was_stopped = stop_requested(communicator);
        if (was_stopped || (parameters.checkpoint_every > 0 &&
                            increments % parameters.checkpoint_every == 0))
          write_checkpoint();
        return !was_stopped;
      }

      void write_checkpoint()
      {
        linear_solver.forget();
        Checkpoint checkpoint(context.output_folder, communicator);
        system.weak_form->save(checkpoint.stream());
        checkpoint.put(recorder.save());
        checkpoint.put(
          {static_cast<double>(increments), newton->largest_force});
        checkpoint.put(increment_state.save());
        checkpoint.put(increment_state.path);
        checkpoint.put(linear_solver.statistics().counts());
        checkpoint.finish();
      }

      void read_checkpoint()
      {
        RestartFile file(context.restart_folder, communicator);
        system.weak_form->load(file.stream());
        recorder.load(file.get());
        const auto values     = file.get();
        increments            = static_cast<unsigned int>(values.at(0));
        newton->largest_force = values.at(1);
        increment_state.load(file.get());
        increment_state.path = file.get();
        linear_solver.continue_from(
          LinearSolverStatistics::from_counts(file.get()));
        recorder.restart();
      }

      RunStatus finish(const StrategyResult &result)
      {
        const RunAccount account = {result,
                                    was_stopped,
                                    increments,
                                    linear_solver.statistics(),
                                    newton->seconds_assembly,
                                    0.,
                                    recorder,
                                    *system.weak_form,
                                    nullptr,
                                    nullptr,
                                    timer};
        const Summary    summary = summarise(account, communicator);
        if (Utilities::MPI::this_mpi_process(communicator) == 0)
          summary.write(context.output_folder + "/summary.json");
        recorder.print(summary);
        recorder.draw(account.times());
        return account.status();
      }

      const NetworkEntries            &entries;
      const SceneParameters           &parameters;
      const RunContext                &context;
      const MPI_Comm                   communicator = MPI_COMM_WORLD;
      Timer                            timer;
      LinearSolver                     linear_solver;
      std::unique_ptr<NonlinearSolver> newton;
      NetworkSystem                    system;
      Recorder                         recorder;
      IncrementState                   increment_state;
      unsigned int                     increments  = 0;
      bool                             was_stopped = false;
    };
  } // namespace

  void NetworkScene::add_parameters(ParameterHandler &prm)
  {
    network.add_parameters(prm);
  }

  void NetworkScene::check(const SceneParameters &parameters) const
  {
    const Network n = network.network();
    Expression(network.motion, "Network/motion");
    Expression(network.load, "Network/load");
    if (n.held.empty() && n.driven.empty())
      throw ExcParameter("Network/held",
                         "the network is held nowhere: at least one of held "
                         "and driven must name a node; got none.");
    if (!n.bonds.empty() && !parameters.interface.adhesion.active())
      throw ExcParameter("Adhesion/law",
                         "must not be none where Network/bonds has entries; "
                         "got none and " +
                           std::to_string(n.bonds.size()) + " bonds.");
    if (parameters.has_inertia())
      throw ExcParameter("Solution/strategy",
                         "must be quasi-static or arc length for a network, "
                         "whose nodes have no mass; got " +
                           parameters.strategy + ".");
  }

  std::string NetworkScene::preview() const
  {
    const Network      n = network.network();
    std::ostringstream text;
    text << "What will be simulated\n"
         << "  network     " << n.nodes.size() << " nodes, " << n.springs.size()
         << " springs, " << n.bars.size() << " bars, " << n.bonds.size()
         << " bonds\n"
         << "  unknowns    " << n.unknowns().size() << '\n';
    return text.str();
  }

  RunStatus NetworkScene::run(const SceneParameters &parameters,
                              const RunContext      &context) const
  {
    return NetworkRun(network, parameters, context).run();
  }
} // namespace demold

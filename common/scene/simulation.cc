// SPDX-License-Identifier: LGPL-2.1-or-later
// The run loop: from a scene to its records, with checkpoints on the way.
#include "scene/simulation.h"

#include "base/stop_signal.h"
#include "scene/checkpoint.h"
#include "scene/interface_table.h"
#include "scene/observe.h"
#include "scene/recorder.h"
#include "scene/run_summary.h"
#include "scene/scene_fields.h"
#include "scene/scene_strategy.h"
#include "scene/scene_system.h"
#include "solid/rigid_modes.h"
#include "solution/blas_check.h"

#include <deal.II/base/timer.h>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// What scaled masses may hold of the energy before anything jumps (theory
    /// D.4).
    constexpr double largest_kinetic_share = .05;

    template <int dim>
    class Simulation
    {
    public:
      Simulation(const Scene<dim>      &scene,
                 const SceneParameters &parameters,
                 const RunContext      &context)
        : scene(scene)
        , parameters(parameters)
        , context(context)
        , communicator(MPI_COMM_WORLD)
        , linear_solver(parameters.linear_solver_of_scene(), communicator)
        , newton(make_nonlinear_solver(parameters.newton, linear_solver))
        , recorder(context,
                   has_interface(scene, parameters),
                   parameters.strategy == "arc length")
      {}

      RunStatus run();

    private:
      void      make_system();
      void      show_cure();
      bool      accept(const IncrementRecord &record);
      bool      is_released(const Observation &now);
      void      write_checkpoint();
      void      read_checkpoint();
      void      judge_mass_scaling(StrategyResult &result);
      RunStatus finish(StrategyResult result);

      const Scene<dim>      &scene;
      const SceneParameters &parameters;
      const RunContext      &context;
      const MPI_Comm         communicator;
      Timer                  timer;
      double                 seconds_output = 0.;

      std::unique_ptr<SceneSystem<dim>> system;
      LinearSolver                      linear_solver;
      std::unique_ptr<NonlinearSolver>  newton;
      Recorder                          recorder;
      std::unique_ptr<SceneFields<dim>> fields;
      IncrementState                    increment_state;
      unsigned int                      records      = 0;  ///< so far
      unsigned int                      increments   = 0;  ///< in these
      double                            last_contact = 0.; ///< opening [mm]
      bool                              was_stopped  = false;
    };

    template <int dim>
    void Simulation<dim>::make_system()
    {
      system =
        std::make_unique<SceneSystem<dim>>(scene, parameters, communicator);
      const WeakForm &weak_form = *system->weak_form;
      if (parameters.linear_solver.linear != "direct" &&
          !weak_form.has_extra_unknowns())
        linear_solver.set_rigid_body_modes(
          rigid_body_modes<dim>(system->dof_handler, weak_form.trial),
          dim);
      fields = std::make_unique<SceneFields<dim>>(scene,
                                                  parameters,
                                                  *system,
                                                  context.output_folder);
    }

    template <int dim>
    void Simulation<dim>::show_cure()
    {
      if (Utilities::MPI::this_mpi_process(communicator) != 0)
        return;
      const std::string warning = system->cure->warning();
      if (!warning.empty())
        recorder.note(warning);
      if (parameters.fields_every == 0)
        return;
      const std::string problem = system->cure->write(context.output_folder);
      if (!problem.empty())
        recorder.note(problem);
    }

    template <int dim>
    bool Simulation<dim>::is_released(const Observation &now)
    {
      if (now.bonded > 0. || now.closed > 0.)
        last_contact = now.opening;
      return scene.after_release >= 0. &&
             now.opening - last_contact >= scene.after_release;
    }

    template <int dim>
    bool Simulation<dim>::accept(const IncrementRecord &record)
    {
      Timer             clock;
      const Observation now = observe(scene, *system, record);
      recorder.record(now);
      ++records;
      increments += record.steps;
      fields->write_if_due(records);
      const bool ends = is_released(now);
      was_stopped     = stop_requested(communicator);
      if (was_stopped || (parameters.checkpoint_every > 0 &&
                          records % parameters.checkpoint_every == 0))
        write_checkpoint();
      seconds_output += clock.wall_time();
      return !ends && !was_stopped;
    }

    template <int dim>
    void Simulation<dim>::write_checkpoint()
    {
      // A restart has no factors to go on with; dropping them here makes the
      // uninterrupted run take the same path.
      linear_solver.forget();
      Checkpoint checkpoint(context.output_folder, communicator);
      system->weak_form->save(checkpoint.stream());
      checkpoint.put(recorder.save());
      checkpoint.put({static_cast<double>(increments),
                      last_contact,
                      newton->largest_force,
                      static_cast<double>(records)});
      checkpoint.put(increment_state.save());
      checkpoint.put(increment_state.path);
      checkpoint.put(linear_solver.statistics().counts());
      checkpoint.put(fields->times());
      checkpoint.finish();
    }

    template <int dim>
    void Simulation<dim>::read_checkpoint()
    {
      RestartFile file(context.restart_folder, communicator);
      system->weak_form->load(file.stream());
      recorder.load(file.get());
      const auto values     = file.get();
      increments            = static_cast<unsigned int>(values.at(0));
      last_contact          = values.at(1);
      newton->largest_force = values.at(2);
      records               = static_cast<unsigned int>(values.at(3));
      increment_state.load(file.get());
      increment_state.path = file.get();
      linear_solver.continue_from(
        LinearSolverStatistics::from_counts(file.get()));
      fields->restart(file.get());
      recorder.restart();
    }

    template <int dim>
    void Simulation<dim>::judge_mass_scaling(StrategyResult &result)
    {
      const double scaling = parameters.explicit_dynamics.mass_scaling;
      const double share   = recorder.kinetic_share_to_peak();
      if (!parameters.is_explicit() || scaling <= 1. ||
          share <= largest_kinetic_share)
        return;
      char text[200];
      std::snprintf(text,
                    sizeof(text),
                    "WARNING: up to the peak force kinetic energy reached %.3g "
                    "%% of the largest entry of the ledger, more than %g %%: "
                    "lower Solution/mass scaling = %g",
                    100. * share,
                    100. * largest_kinetic_share,
                    scaling);
      result.events.emplace_back(text);
      recorder.note(text);
    }

    template <int dim>
    RunStatus Simulation<dim>::finish(StrategyResult result)
    {
      Timer clock;
      judge_mass_scaling(result);
      fields->write_last(records);
      if (system->interface != nullptr)
        write_interface_table(context.output_folder + "/interface.csv",
                              *system->interface);
      seconds_output += clock.wall_time();
      const RunAccount account = {result,
                                  was_stopped,
                                  increments,
                                  linear_solver.statistics(),
                                  newton->seconds_assembly,
                                  seconds_output,
                                  recorder,
                                  *system->weak_form,
                                  system->interface,
                                  system->cure ? &system->cure->range() :
                                                 nullptr,
                                  timer};
      const Summary    summary = summarise(account, communicator);
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        summary.write(context.output_folder + "/summary.json");
      recorder.print(summary);
      recorder.draw(account.times());
      return account.status();
    }

    template <int dim>
    RunStatus Simulation<dim>::run()
    {
      if (on_reference_blas())
        recorder.note(blas_advice());
      make_system();
      if (system->cure != nullptr)
        show_cure();
      const bool is_restart = !context.restart_folder.empty();
      if (!is_restart)
        fields->write_first();
      const Strategy strategy = make_strategy(scene,
                                              parameters,
                                              *system,
                                              {*system->weak_form,
                                               *newton,
                                               linear_solver,
                                               scene.end_time,
                                               [this](const std::string &text) {
                                                 recorder.note(text);
                                               }},
                                              increment_state);
      if (is_restart)
        read_checkpoint();
      return finish(strategy(
        [this](const IncrementRecord &record) { return accept(record); }));
    }
  } // namespace

  template <int dim>
  RunStatus run_simulation(const Scene<dim>      &scene,
                           const SceneParameters &parameters,
                           const RunContext      &context)
  {
    return Simulation<dim>(scene, parameters, context).run();
  }

  template RunStatus run_simulation<2>(const Scene<2> &,
                                       const SceneParameters &,
                                       const RunContext &);
  template RunStatus run_simulation<3>(const Scene<3> &,
                                       const SceneParameters &,
                                       const RunContext &);
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// A scene brought to life: mesh, terms, strategy, records.
#include "scene/simulation.h"

#include "adhesion/stability_number.h"
#include "base/parameter_error.h"
#include "base/stop_signal.h"
#include "contact/node_to_segment.h"
#include "scene/checkpoint.h"
#include "scene/expression.h"
#include "scene/field_output.h"
#include "scene/interface_table.h"
#include "scene/mould_output.h"
#include "scene/recorder.h"
#include "scene/scene_supports.h"
#include "solid/dead_traction.h"
#include "solid/finite_strain_solid.h"
#include "solid/lumped_mass.h"
#include "solid/rigid_modes.h"
#include "solution/blas_check.h"
#include "solution/dynamics.h"
#include "solution/quasi_static.h"
#include "weak_form/weak_form.h"

#include <deal.II/base/timer.h>

#include <deal.II/distributed/shared_tria.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    class Simulation
    {
    public:
      Simulation(const Scene<dim> &     scene,
                 const SceneParameters &parameters,
                 const RunContext &     context)
        : scene(scene)
        , parameters(parameters)
        , context(context)
        , communicator(MPI_COMM_WORLD)
        , triangulation(communicator,
                        Triangulation<dim>::none,
                        false,
                        parallel::shared::Triangulation<
                          dim>::Settings::partition_metis)
        , fe(FE_Q<dim>(parameters.element == "q2" ? 2 : 1), dim)
        , dof_handler(triangulation)
        , linear_solver(parameters.linear_solver, communicator)
        , newton(make_nonlinear_solver(parameters.newton, linear_solver))
        , recorder(context, has_interface())
      {}

      RunStatus run();

    private:
      bool has_interface() const
      {
        return parameters.interface.active() && !scene.slave.empty();
      }

      void              make_system();
      void              add_solids();
      void              add_interface();
      void              set_rigid_modes();
      StrategyResult    solve();
      bool              accept(const IncrementRecord &record);
      Observation       observe(const IncrementRecord &record) const;
      double            measured_force(const double time) const;
      bool              is_released(const Observation &now);
      void              make_fields();
      void              write_fields();
      void              write_checkpoint();
      void              read_checkpoint();
      RunStatus         finish(const StrategyResult &result);

      const Scene<dim> &     scene;
      const SceneParameters &parameters;
      const RunContext &     context;
      const MPI_Comm         communicator;
      Timer                  timer;
      double                 seconds_output = 0.;

      parallel::shared::Triangulation<dim> triangulation;
      const FESystem<dim>                  fe;
      DoFHandler<dim>                      dof_handler;
      std::unique_ptr<SceneSupports>       supports;
      std::unique_ptr<WeakForm>            weak_form;
      NodeToSegment *                      interface = nullptr;
      LinearSolver                         linear_solver;
      std::unique_ptr<NonlinearSolver> newton;
      Recorder                             recorder;
      std::vector<const CellResults *>     solids;
      std::unique_ptr<FieldOutput<dim>>    fields;
      std::unique_ptr<MouldOutput<dim>>    mould;
      IncrementState                       increment_state;
      unsigned int                         increments   = 0;
      unsigned int                         rejected     = 0; ///< so far
      unsigned int                         rejected_before_restart = 0;
      double                               last_contact = 0.; ///< opening [mm]
      bool                                 was_stopped  = false;
    };

    template <int dim>
    void Simulation<dim>::make_system()
    {
      scene.make_mesh(triangulation);
      dof_handler.distribute_dofs(fe);
      IndexSet relevant;
      DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
      supports = std::make_unique<SceneSupports>(
        collect_supports(dof_handler, scene.supports));
      const DisplacementSpace space = {
        communicator,
        dof_handler.locally_owned_dofs(),
        relevant,
        [this](DynamicSparsityPattern &         pattern,
               const AffineConstraints<double> &constraints) {
          DoFTools::make_sparsity_pattern(
            dof_handler,
            pattern,
            constraints,
            false,
            Utilities::MPI::this_mpi_process(communicator));
        }};
      weak_form = std::make_unique<WeakForm>(space, supports->supports());
      add_solids();
      add_interface();
      weak_form->setup();
      set_rigid_modes();
      if (parameters.fields_every > 0)
        make_fields();
    }

    template <int dim>
    void Simulation<dim>::make_fields()
    {
      fields = std::make_unique<FieldOutput<dim>>(
        dof_handler,
        solids,
        parameters.interface.search_distance,
        context.output_folder);
      if (scene.mould)
        mould = std::make_unique<MouldOutput<dim>>(*scene.mould,
                                                   scene.motion,
                                                   context.output_folder);
    }

    template <int dim>
    void Simulation<dim>::write_fields()
    {
      if (!fields)
        return;
      fields->write(weak_form->accepted, interface, weak_form->time());
      if (mould)
        mould->write(weak_form->time());
    }

    template <int dim>
    void Simulation<dim>::add_solids()
    {
      std::set<types::material_id> ids;
      for (const auto &cell : dof_handler.active_cell_iterators())
        ids.insert(cell->material_id());
      const RubberModel &rubber = parameters.material;
      const auto         f90    = std::make_shared<Expression>(
        rubber.f90_expression(), "Material/f90");
      for (const auto id : ids)
        {
          SolidDescription description;
          description.material_id = id;
          description.element     = parameters.element;
          description.plane       = parameters.plane();
          description.uniform_law = rubber.f90_is_uniform();
          description.law         = [&rubber, f90](const dealii::Point<3> &X) {
            return rubber.at((*f90)(0., X));
          };
          description.f90 = [f90](const dealii::Point<3> &X) {
            return (*f90)(0., X);
          };
          solids.push_back(dynamic_cast<const CellResults *>(&weak_form->add(
            make_solid_term<dim>(dof_handler, description))));
        }
      for (const TractionRule &rule : scene.tractions)
        weak_form->add(make_dead_traction<dim>(dof_handler,
                                               rule.boundary,
                                               rule.traction,
                                               parameters.plane()));
    }

    template <int dim>
    void Simulation<dim>::add_interface()
    {
      if (!has_interface())
        return;
      std::vector<Facet> facets;
      if (scene.mould)
        for (const auto &facet : scene.mould->facets)
          facets.push_back({facet.v, facet.n});
      interface = static_cast<NodeToSegment *>(
        &weak_form->add(std::make_unique<NodeToSegment>(
          extract_surface<dim>(dof_handler, scene.slave),
          scene.mould ?
            Master::rigid(facets, scene.mould->vertices, scene.motion) :
            Master::deformable(extract_surface<dim>(dof_handler, scene.master)),
          parameters.interface.description(parameters.plane()),
          dof_handler.locally_owned_dofs(),
          communicator)));
    }

    template <int dim>
    void Simulation<dim>::set_rigid_modes()
    {
      if (parameters.linear_solver.linear == "direct" ||
          weak_form->has_extra_unknowns())
        return;
      linear_solver.set_rigid_body_modes(
        rigid_body_modes<dim>(dof_handler, weak_form->trial), dim);
    }

    template <int dim>
    double Simulation<dim>::measured_force(const double time) const
    {
      Tensor<1, 3> force;
      if (scene.force_on == Scene<dim>::ForceOn::supports)
        {
          const double dt = 1e-6 * scene.end_time;
          return supports->power(time, dt, weak_form->force) * 2. * dt /
                 (scene.opening(time + dt) - scene.opening(time - dt)) *
                 scene.symmetry_factor;
        }
      if (scene.force_on == Scene<dim>::ForceOn::boundary)
        force = supports->reaction(scene.force_boundary, weak_form->force);
      else if (interface != nullptr)
        force = interface->sums().force;
      return force * scene.direction(time) * scene.symmetry_factor;
    }

    template <int dim>
    Observation Simulation<dim>::observe(const IncrementRecord &record) const
    {
      Observation now;
      now.time    = record.time;
      now.opening = scene.opening(record.time);
      now.force   = measured_force(record.time);
      auto e      = weak_form->energies().as_array();
      for (double &entry : e)
        entry *= scene.symmetry_factor;
      now.energies = Energies::from_array(e);
      if (interface != nullptr)
        {
          const InterfaceSums sums = interface->sums();
          now.bonded               = sums.bonded * scene.symmetry_factor;
          now.closed               = sums.closed * scene.symmetry_factor;
          now.area                 = sums.area * scene.symmetry_factor;
        }
      for (const CellResults *solid : solids)
        for (const CellResult &cell : solid->cell_results())
          {
            now.stretch = std::max(now.stretch, cell.largest_stretch);
            now.tension = std::max(now.tension, cell.largest_tension);
          }
      now.stretch    = Utilities::MPI::max(now.stretch, communicator);
      now.tension    = Utilities::MPI::max(now.tension, communicator);
      now.iterations = record.newton.iterations;
      now.rejected   = rejected_before_restart + record.rejected;
      now.strategy   = record.strategy;
      now.done       = record.time / scene.end_time;
      return now;
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
      const Observation now = observe(record);
      recorder.record(now);
      rejected = now.rejected;
      ++increments;
      if (fields && increments % parameters.fields_every == 0)
        write_fields();
      const bool ends = is_released(now);
      was_stopped     = stop_requested(communicator);
      if (was_stopped || (parameters.checkpoint_every > 0 &&
                          increments % parameters.checkpoint_every == 0))
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
      weak_form->save(checkpoint.stream());
      checkpoint.put(recorder.save());
      checkpoint.put({increment_state.dt,
                      increment_state.last_dt,
                      static_cast<double>(increments),
                      last_contact,
                      newton->largest_force,
                      static_cast<double>(rejected)});
      checkpoint.put(fields ? fields->series.times() : std::vector<double>());
      checkpoint.finish();
    }

    template <int dim>
    void Simulation<dim>::read_checkpoint()
    {
      RestartFile file(context.restart_folder, communicator);
      weak_form->load(file.stream());
      recorder.load(file.get());
      const auto values       = file.get();
      increment_state.dt      = values.at(0);
      increment_state.last_dt = values.at(1);
      increments              = static_cast<unsigned int>(values.at(2));
      last_contact            = values.at(3);
      newton->largest_force    = values.at(4);
      rejected_before_restart = rejected =
        static_cast<unsigned int>(values.at(5));
      const auto times        = file.get();
      if (fields)
        fields->series.restart(times);
      if (mould)
        mould->series.restart(times);
      recorder.restart();
    }

    template <int dim>
    StrategyResult Simulation<dim>::solve()
    {
      IncrementParameters increments = parameters.increments;
      if (increments.largest <= 0.)
        increments.largest = scene.end_time / 50.;
      if (increments.first <= 0.)
        increments.first = std::min(increments.largest, scene.end_time / 200.);
      if (increments.smallest <= 0.)
        increments.smallest = 1e-9 * scene.end_time;
      increments.state = &increment_state;

      const auto on_accept = [this](const IncrementRecord &record) {
        return accept(record);
      };
      const bool dynamic = parameters.strategy == "dynamics";
      Inertia *  inertia = nullptr;
      if (dynamic)
        {
          const double length =
            parameters.accuracy * (parameters.interface.adhesion.active() ?
                                     parameters.interface.adhesion.rupture_gap :
                                     .1 * scene.height);
          inertia = static_cast<Inertia *>(
            &weak_form->add(std::make_unique<Inertia>(
              lumped_mass<dim>(dof_handler,
                               parameters.plane(),
                               parameters.material.density,
                               weak_form->trial),
              parameters.integrator,
              length)));
        }
      if (!context.restart_folder.empty())
        read_checkpoint();
      if (dynamic)
        return run_dynamics(*weak_form,
                            *newton,
                            *inertia,
                            parameters.integrator,
                            increments,
                            scene.end_time,
                            on_accept);
      return run_quasi_static(
        *weak_form, *newton, increments, scene.end_time, on_accept);
    }

    template <int dim>
    RunStatus Simulation<dim>::finish(const StrategyResult &result)
    {
      Timer clock;
      if (fields && increments % parameters.fields_every != 0)
        write_fields();
      if (interface != nullptr)
        write_interface_table(context.output_folder + "/interface.csv",
                              *interface);
      std::size_t history = 0;
      for (const auto &term : weak_form->term_list())
        history += term->history_bytes();

      Summary summary;
      summary.set("status",
                  result.gave_up || was_stopped ? "gave up" :
                  recorder.n_jumps > 0          ? "completed with jumps" :
                                                  "completed");
      summary.set("reason",
                  was_stopped ? std::string("stopped by SIGTERM") :
                                result.reason);
      recorder.summarise(summary);
      const LinearSolverStatistics &linear = linear_solver.statistics();
      summary.set("increments", increments);
      summary.set("rejected increments",
                  rejected_before_restart + result.rejected);
      summary.set("newton iterations", result.newton_iterations);
      summary.set("factorisations", linear.factorisations);
      summary.set("multigrid hierarchies", linear.hierarchies);
      summary.set("krylov iterations", linear.krylov_iterations);
      summary.set("degrees of freedom",
                  static_cast<long long>(weak_form->n_unknowns()));
      summary.set("contact nodes",
                  interface == nullptr ? 0u : interface->sums().points);
      summary.set("history [MiB]",
                  Utilities::MPI::sum(static_cast<double>(history),
                                      communicator) /
                    (1 << 20));
      const double time_contact = interface == nullptr ? 0. : interface->seconds;
      const double time_linear  = linear.seconds_setup + linear.seconds_solve;
      seconds_output += clock.wall_time();
      const std::vector<std::pair<std::string, double>> times = {
        {"assembly", newton->seconds_assembly - time_contact},
        {"contact", time_contact},
        {"linear solver", time_linear},
        {"output", seconds_output}};
      for (const auto &part : times)
        summary.set("time " + part.first + " [s]", part.second);
      Utilities::System::MemoryStats memory;
      Utilities::System::get_memory_stats(memory);
      summary.set("peak memory [MiB]",
                  Utilities::MPI::sum(memory.VmHWM / 1024., communicator));
      summary.set("ranks", Utilities::MPI::n_mpi_processes(communicator));
      summary.set("versions", "demold 0.1, deal.II " DEAL_II_PACKAGE_VERSION);
      summary.set("cpu time [s]",
                  Utilities::MPI::sum(timer.cpu_time(), communicator));
      summary.set("wall time [s]", timer.wall_time());
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        summary.write(context.output_folder + "/summary.json");
      recorder.print(summary);
      recorder.draw(times);
      return result.gave_up || was_stopped ? RunStatus::gave_up :
                                             RunStatus::completed;
    }

    template <int dim>
    RunStatus Simulation<dim>::run()
    {
      if (on_reference_blas())
        recorder.note(blas_advice());
      make_system();
      if (context.restart_folder.empty())
        write_fields();
      return finish(solve());
    }
  } // namespace

  namespace
  {
    /// Longest edge [mm] of the faces that may stick.
    template <int dim>
    double largest_edge(const Triangulation<dim> &          mesh,
                        const std::set<types::boundary_id> &boundaries)
    {
      double largest = 0.;
      for (const auto &cell : mesh.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && boundaries.count(face->boundary_id()) > 0)
            {
              if constexpr (dim == 2)
                largest = std::max(largest, face->measure());
              else
                for (unsigned int e = 0; e < face->n_lines(); ++e)
                  largest = std::max(largest, face->line(e)->measure());
            }
      return largest;
    }

    std::string mesh_warning(const double edge, const double cohesive_zone)
    {
      std::ostringstream text;
      if (edge > cohesive_zone / 3.)
        text << "WARNING: interface elements reach " << edge
             << " mm, above l_cz/3 = " << cohesive_zone / 3.
             << " mm: the cohesive zone is not resolved, force and jumps will "
                "depend on the mesh. Make elements smaller, or lower the "
                "strength at equal G_c.\n";
      return text.str();
    }
  } // namespace

  template <int dim>
  RunStatus run_simulation(const Scene<dim> &     scene,
                           const SceneParameters &parameters,
                           const RunContext &     context)
  {
    return Simulation<dim>(scene, parameters, context).run();
  }

  template <int dim>
  std::string preview_simulation(const Scene<dim> &     scene,
                                 const SceneParameters &parameters)
  {
    Triangulation<dim> mesh;
    scene.make_mesh(mesh);
    const unsigned int degree = parameters.element == "q2" ? 2 : 1;
    const double       unknowns =
      degree == 1 ? dim * static_cast<double>(mesh.n_used_vertices()) :
                    dim * std::pow(2., dim) * mesh.n_active_cells();
    const RubberLaw law =
      parameters.material.at(parameters.material.f90_is_uniform() ?
                               parameters.material.uniform_f90() :
                               parameters.material.f90_range().second);
    const auto history =
      static_cast<double>(law.n_history() * mesh.n_active_cells()) *
      std::pow(degree + 1, dim) * 16.;

    std::ostringstream text;
    text << "What will be simulated\n"
         << "  rubber      " << parameters.element << ", "
         << mesh.n_active_cells() << " cells, about "
         << static_cast<long>(unknowns) << " unknowns, "
         << law.branches.size() << " Maxwell branches\n"
         << "  contact     "
         << (scene.slave.empty() ? "none" : parameters.interface.formulation)
         << (scene.mould ? ", rigid mould of " +
                             std::to_string(scene.mould->facets.size()) +
                             " facets" :
                           "")
         << "\n  adhesion    " << parameters.interface.adhesion.law_name
         << "\n  friction    ";
    if (parameters.interface.friction > 0.)
      text << "mu = " << parameters.interface.friction << '\n';
    else
      text << "none\n";
    text << "  strategy    " << parameters.strategy << " until "
         << scene.end_time << " s at the latest\n"
         << "  memory      history " << std::setprecision(3)
         << history / (1 << 20) << " MiB, direct factor about "
         << (dim == 2 ? unknowns * 1e-3 : 1.2e-5 * std::pow(unknowns, 4. / 3.))
         << " MiB\n";
    if (parameters.interface.adhesion.active() && !scene.slave.empty())
      {
        const StabilityPreview stability =
          stability_preview(parameters.interface.adhesion.law().softening,
                            law.young_relaxed(),
                            law.young_instantaneous(),
                            law.poisson_relaxed(),
                            scene.height);
        text << stability.text()
             << mesh_warning(largest_edge(mesh, scene.slave),
                             stability.relaxed.cohesive_zone);
      }
    return text.str();
  }

  template RunStatus run_simulation<2>(const Scene<2> &,
                                       const SceneParameters &,
                                       const RunContext &);
  template RunStatus run_simulation<3>(const Scene<3> &,
                                       const SceneParameters &,
                                       const RunContext &);
  template std::string preview_simulation<2>(const Scene<2> &,
                                             const SceneParameters &);
  template std::string preview_simulation<3>(const Scene<3> &,
                                             const SceneParameters &);
} // namespace demold

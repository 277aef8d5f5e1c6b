// SPDX-License-Identifier: LGPL-2.1-or-later
// Explicit dynamics: very many short steps, none of which solves a system.
#include "solution/explicit_dynamics.h"

#include "solution/central_differences.h"
#include "solution/critical_step_watch.h"
#include "solution/explicit_parameters.h"
#include "weak_form/weak_form.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Steps between two looks at the energies.
    constexpr unsigned int look_every = 100;

    /// Kinetic energy of free nodes over what work and persistency have
    /// brought that no stable run has: the integrator lends at most as much.
    constexpr double runaway = 10.;

    /// Energy that contact may bring, over the same (theory D.4).
    constexpr double most_from_impacts = .01;

    class ExplicitRun
    {
    public:
      ExplicitRun(WeakForm                  &weak_form,
                  const ExplicitTools       &tools,
                  const IncrementParameters &increments,
                  const double               end_time,
                  const OnAccept            &on_accept);

      StrategyResult run();

    private:
      bool   interval();
      bool   step(const double dt);
      void   start();
      void   look_at_critical_step();
      bool   is_sound();
      double next_step(const double record_time) const;
      void   judge_impacts();
      void   give_up(const std::string &what);
      void   save();
      void   load();

      WeakForm                  &weak_form;
      const ExplicitTools       &tools;
      const IncrementParameters &increments;
      const double               end_time;
      const OnAccept            &on_accept;
      const MPI_Comm             communicator;

      IncrementState    local;
      IncrementState   &state;
      CriticalStepWatch watch;
      StrategyResult    result;
      double            records     = 0.; ///< intervals so far
      double            steps       = 0.; ///< so far
      double            noted       = 0.; ///< [s] critical step, on the console
      double            work        = 0.; ///< [mJ] largest supply so far
      unsigned int      in_interval = 0;  ///< steps
    };

    ExplicitRun::ExplicitRun(WeakForm                  &weak_form,
                             const ExplicitTools       &tools,
                             const IncrementParameters &increments,
                             const double               end_time,
                             const OnAccept            &on_accept)
      : weak_form(weak_form)
      , tools(tools)
      , increments(increments)
      , end_time(end_time)
      , on_accept(on_accept)
      , communicator(weak_form.accepted.get_mpi_communicator())
      , state(increments.state != nullptr ? *increments.state : local)
      , watch(weak_form, tools.motion.masses())
    {}

    StrategyResult ExplicitRun::run()
    {
      if (state.path.empty())
        start();
      else
        load();
      const double tiny = 1e-12 * end_time;
      while (end_time - weak_form.time() > tiny)
        if (!interval())
          break;
      judge_impacts();
      return result;
    }

    /// Loads that are there at once act from the first step on.
    void ExplicitRun::start()
    {
      weak_form.begin_increment(weak_form.time() + 1e-12 * end_time, 0.);
      weak_form.assemble(false, 0);
      tools.motion.start(weak_form);
      weak_form.reject();
    }

    /// All steps up to the next record; false ends the run.
    bool ExplicitRun::interval()
    {
      const double start = weak_form.time();
      const double next  = (records + 1.) * increments.largest;
      // No record of what round-off leaves at the end.
      const double record_time =
        next < end_time - 1e-3 * increments.largest ? next : end_time;
      const double first = steps;
      in_interval        = 0;
      while (record_time - weak_form.time() > 1e-9 * (record_time - start))
        {
          look_at_critical_step();
          if (!step(next_step(record_time)))
            return false;
        }
      if (!is_sound())
        return false;
      records += 1.;
      save();
      IncrementRecord record = {weak_form.time(),
                                weak_form.time() - start,
                                {},
                                "explicit dynamics",
                                0,
                                {}};
      record.steps           = static_cast<unsigned int>(steps - first);
      result.increments += record.steps;
      return on_accept(record);
    }

    /// Equal steps that end at @p record_time.
    double ExplicitRun::next_step(const double record_time) const
    {
      const double rest = record_time - weak_form.time();
      const double dt   = tools.parameters.safety * watch.critical();
      return rest / std::max(1., std::ceil(rest / dt * (1. - 1e-9)));
    }

    bool ExplicitRun::step(const double dt)
    {
      const Timer timer;
      weak_form.begin_increment(weak_form.time() + dt, 0.);
      weak_form.update(tools.motion.increment(dt), 1.);
      const bool admissible = weak_form.assemble(false, 0);
      tools.seconds_assembly += timer.wall_time();
      if (!admissible)
        {
          weak_form.reject();
          give_up("an element turned inside out");
          return false;
        }
      // After a restart the first step of an interval has no states before it.
      bool changed = in_interval > 0 && weak_form.n_state_changes() > 0;
      tools.motion.kick(weak_form, dt);
      weak_form.accept();
      for (const auto &term : weak_form.term_list())
        {
          const auto points = term->closed_points();
          if (Utilities::MPI::max(points.empty() ? 0 : 1, communicator) == 0)
            continue;
          changed = true;
          tools.motion.close(points);
        }
      steps += 1.;
      ++in_interval;
      watch.count(changed);
      return std::fmod(steps, look_every) != 0. || is_sound();
    }

    void ExplicitRun::look_at_critical_step()
    {
      const Timer timer;
      // The tangent of a step that is short for the rubber.
      const double last   = tools.parameters.safety * watch.critical();
      const bool   looked = watch.look(last > 0. ? last : 1e-9 * end_time);
      tools.seconds_assembly += timer.wall_time();
      const double critical = watch.critical();
      if (!looked || (noted > 0. && critical > .5 * noted))
        return;
      noted = critical;
      char text[160];
      std::snprintf(text,
                    sizeof(text),
                    "time %.6g s: critical step %.4g s, %.3g steps to the end",
                    weak_form.time(),
                    critical,
                    (end_time - weak_form.time()) /
                      (tools.parameters.safety * critical));
      result.events.emplace_back(text);
      tools.note(text);
    }

    /// Is there no more energy than work has brought?
    bool ExplicitRun::is_sound()
    {
      const Energies now     = weak_form.energies();
      const double   kinetic = tools.motion.free_kinetic_energy();
      work = std::max(work, std::abs(now.external) + std::abs(now.impact));
      if (std::isfinite(kinetic) && std::isfinite(now.stored) &&
          kinetic <= runaway * work + 1e-12)
        return true;
      char text[120];
      std::snprintf(text,
                    sizeof(text),
                    "the kinetic energy of %.3g mJ exceeds %g times the work "
                    "of %.3g mJ",
                    tools.energy_factor * kinetic,
                    runaway,
                    tools.energy_factor * work);
      give_up(text);
      return false;
    }

    /// Contact takes energy. Where it brings some, steps are too long for it.
    void ExplicitRun::judge_impacts()
    {
      const double impact = weak_form.energies().impact;
      if (impact >= -most_from_impacts * work)
        return;
      char text[160];
      std::snprintf(
        text,
        sizeof(text),
        "WARNING: contact has brought %.3g mJ, %.3g %% of the work: "
        "lower Solution/safety factor or mass scaling",
        -tools.energy_factor * impact,
        -100. * impact / work);
      result.events.emplace_back(text);
      tools.note(text);
    }

    void ExplicitRun::give_up(const std::string &what)
    {
      const double safety = tools.parameters.safety;
      char         text[400];
      std::snprintf(text,
                    sizeof(text),
                    "step %.0f of explicit dynamics at time %.6g s: %s. Steps "
                    "are %.4g s, the critical one was found to be %.4g s. Try "
                    "a smaller Solution/safety factor than %g%s",
                    steps + 1.,
                    weak_form.time(),
                    what.c_str(),
                    safety * watch.critical(),
                    watch.critical(),
                    safety,
                    safety > 1. ? ": above 1 the integration is unstable" : "");
      result.gave_up = true;
      result.reason  = text;
    }

    void ExplicitRun::save()
    {
      state.path         = {records, steps, noted, work};
      const auto watched = watch.save();
      state.path.insert(state.path.end(), watched.begin(), watched.end());
    }

    void ExplicitRun::load()
    {
      records = state.path.at(0);
      steps   = state.path.at(1);
      noted   = state.path.at(2);
      work    = state.path.at(3);
      watch.load({state.path.begin() + 4, state.path.end()});
    }
  } // namespace

  StrategyResult run_explicit_dynamics(WeakForm                  &weak_form,
                                       const ExplicitTools       &tools,
                                       const IncrementParameters &increments,
                                       const double               end_time,
                                       const OnAccept            &on_accept)
  {
    weak_form.set_bulk_weight(1.);
    return ExplicitRun(weak_form, tools, increments, end_time, on_accept).run();
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Explicit dynamics: very many short steps, none of which solves a system.
#include "solution/explicit_dynamics.h"

#include "solution/central_differences.h"
#include "solution/critical_step.h"
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
    /// Steps after which the critical one is found anew.
    constexpr unsigned int longest_trust = 1000;

    /// Where points have closed it is found at once, as contact may be stiffer
    /// than the rubber: so many times in a row, then once in so many steps.
    constexpr double most_credit = 20., steps_per_credit = 50.;

    /// Steps between two looks at the energies.
    constexpr unsigned int look_every = 100;

    /// Kinetic energy of free nodes over what work and persistency have
    /// brought that no stable run has: the integrator lends at most as much.
    constexpr double runaway = 10.;

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
      void   find_critical_step_if_due();
      void   find_critical_step();
      bool   is_sound();
      double next_step(const double record_time) const;
      void   give_up(const std::string &what);
      void   save();
      void   load();

      WeakForm                  &weak_form;
      const ExplicitTools       &tools;
      const IncrementParameters &increments;
      const double               end_time;
      const OnAccept            &on_accept;
      const MPI_Comm             communicator;

      IncrementState  local;
      IncrementState &state;
      StrategyResult  result;
      double          records  = 0.; ///< intervals so far
      double          steps    = 0.; ///< so far
      double          trusted  = 0.; ///< steps since dt_c could last grow
      double          critical = 0.; ///< [s]
      double          noted    = 0.; ///< [s] critical step on the console
      double          work     = 0.; ///< [mJ] largest supply so far
      double          credit   = most_credit;
      bool            closing  = false; ///< points, since the last look at dt_c
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
      while (record_time - weak_form.time() > 1e-9 * (record_time - start))
        {
          find_critical_step_if_due();
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
      const double dt   = tools.parameters.safety * critical;
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
      tools.motion.kick(weak_form, dt);
      weak_form.accept();
      for (const auto &term : weak_form.term_list())
        {
          const auto points = term->closed_points();
          if (Utilities::MPI::max(points.empty() ? 0 : 1, communicator) == 0)
            continue;
          closing = true;
          tools.motion.close(points);
        }
      steps += 1.;
      trusted += 1.;
      credit = std::min(most_credit, credit + 1. / steps_per_credit);
      return std::fmod(steps, look_every) != 0. || is_sound();
    }

    /// Chattering points would make the step jump up and down: what is found
    /// where they close may only lower it.
    void ExplicitRun::find_critical_step_if_due()
    {
      if (critical == 0. || trusted >= longest_trust)
        find_critical_step();
      else if (closing && credit >= 1.)
        {
          const double before = critical, age = trusted;
          credit -= 1.;
          find_critical_step();
          critical = std::min(critical, before);
          trusted  = age;
        }
    }

    void ExplicitRun::find_critical_step()
    {
      const Timer timer;
      // The tangent of a step that is short for the rubber.
      const double dt =
        critical > 0. ? tools.parameters.safety * critical : 1e-9 * end_time;
      critical = critical_step(weak_form, tools.motion.masses(), dt);
      tools.seconds_assembly += timer.wall_time();
      trusted = 0.;
      closing = false;
      if (noted > 0. && critical > .5 * noted)
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
                    kinetic,
                    runaway,
                    work);
      give_up(text);
      return false;
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
                    safety * critical,
                    critical,
                    safety,
                    safety > 1. ? ": above 1 the integration is unstable" : "");
      result.gave_up = true;
      result.reason  = text;
    }

    void ExplicitRun::save()
    {
      state.path = {records,
                    steps,
                    trusted,
                    critical,
                    noted,
                    work,
                    credit,
                    closing ? 1. : 0.};
    }

    void ExplicitRun::load()
    {
      records  = state.path.at(0);
      steps    = state.path.at(1);
      trusted  = state.path.at(2);
      critical = state.path.at(3);
      noted    = state.path.at(4);
      work     = state.path.at(5);
      credit   = state.path.at(6);
      closing  = state.path.at(7) > 0.;
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

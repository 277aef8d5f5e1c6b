// SPDX-License-Identifier: LGPL-2.1-or-later
// The cheapest strategy that is stable at the moment.
#include "solution/automatic.h"

#include "solution/adaptive_increments.h"
#include "solution/books.h"
#include "solution/dynamics.h"
#include "solution/inertia.h"
#include "solution/path_detour.h"
#include "solution/quasi_static.h"
#include "weak_form/weak_form.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace demold
{
  namespace
  {
    /// Quasi-static increments below this share of the largest one are left to
    /// dynamics: whatever still happens in them is fast.
    constexpr double shortest_quasi_static = 1e-2;

    /// Inertia forces over the largest force of the run that count as none.
    constexpr double no_inertia = 1e-3;

    /// Increments in a row without inertia before dynamics ends, at least and
    /// at most.
    constexpr unsigned int shortest_calm = 3, longest_calm = 96;

    /// A quasi-static phase of fewer increments has begun too early.
    constexpr unsigned int short_phase = 10;

    /// Points along the path of one detour.
    constexpr unsigned int longest_detour = 30;

    /// Jumps left to dynamics after a detour in vain, at most.
    constexpr unsigned int most_skipped = 63;

    /// Where a run stands, see run_automatic().
    class Controller
    {
    public:
      Controller(WeakForm                  &weak_form,
                 const AutomaticTools      &tools,
                 const IncrementParameters &increments,
                 const double               end_time,
                 const OnAccept            &on_accept);

      StrategyResult run();

    private:
      void quasi_static_phase();
      bool detour(const Books               &books,
                  const IncrementParameters &parameters,
                  const std::string         &why);
      void dynamic_phase();
      void add(const StrategyResult &phase);
      bool pass_on(const IncrementRecord &record);
      bool is_calm() const;
      void note(const std::string &event);
      void save();
      void load();

      WeakForm                  &weak_form;
      const AutomaticTools      &tools;
      const IncrementParameters &increments;
      const double               end_time;
      const OnAccept            &on_accept;

      IncrementState  local;
      IncrementState &state;
      StrategyResult  result;
      bool            goes_on     = true;
      unsigned int    in_phase    = 0; ///< increments
      unsigned int    calm        = 0; ///< increments in a row
      unsigned int    calm_needed = shortest_calm;
      unsigned int    to_skip     = 0;  ///< jumps before the next detour
      unsigned int    skip        = 0;  ///< after the next detour in vain
      double          released    = 0.; ///< [mJ] by detours
    };



    Controller::Controller(WeakForm                  &weak_form,
                           const AutomaticTools      &tools,
                           const IncrementParameters &increments,
                           const double               end_time,
                           const OnAccept            &on_accept)
      : weak_form(weak_form)
      , tools(tools)
      , increments(increments)
      , end_time(end_time)
      , on_accept(on_accept)
      , state(increments.state != nullptr ? *increments.state : local)
    {}



    StrategyResult Controller::run()
    {
      if (state.path.empty())
        tools.inertia.set_at_rest(true);
      else
        load();
      const double tiny = 1e-12 * end_time;
      while (goes_on && end_time - weak_form.time() > tiny)
        if (tools.inertia.is_at_rest())
          quasi_static_phase();
        else
          dynamic_phase();
      weak_form.set_bulk_weight(1.);
      return result;
    }



    void Controller::quasi_static_phase()
    {
      Books               books(weak_form);
      IncrementParameters parameters = increments;
      parameters.state               = &state;
      parameters.smallest =
        std::max(increments.smallest,
                 shortest_quasi_static * increments.largest);
      weak_form.set_bulk_weight(1.);
      const StrategyResult phase =
        run_increments(weak_form,
                       tools.path.newton,
                       parameters,
                       end_time,
                       quasi_static_hooks(weak_form, books, 0.),
                       [&](const IncrementRecord &record) {
                         return pass_on(record);
                       });
      add(phase);
      const std::string why = phase.reason.substr(0, phase.reason.find(';'));
      if (!phase.gave_up || detour(books, parameters, why))
        return;
      calm_needed = in_phase < short_phase ?
                      std::min(2 * calm_needed, longest_calm) :
                      shortest_calm;
      in_phase = calm = 0;
      state.dt        = std::max(state.dt, increments.smallest);
      tools.inertia.set_at_rest(false);
      note("dynamics, because " + why);
    }



    /// Past a jump that is too small to matter; false if it matters, or if no
    /// path is found.
    bool Controller::detour(const Books               &books,
                            const IncrementParameters &parameters,
                            const std::string         &why)
    {
      const double left = books.tolerated() - released;
      if (!tools.detours || to_skip > 0 || left <= 0.)
        {
          to_skip -= to_skip > 0 ? 1 : 0;
          return false;
        }
      const auto record        = try_detour(weak_form,
                                     tools.path,
                                     parameters,
                                     end_time,
                                     {left, longest_detour});
      result.newton_iterations = state.newton_iterations;
      result.rejected          = state.rejected;
      if (!record)
        {
          to_skip = skip = std::min(2 * skip + 1, most_skipped);
          return false;
        }
      skip = 0;
      released += std::abs(record->path->released);
      char text[60];
      std::snprintf(text,
                    sizeof(text),
                    "arc length, %.3g mJ released, because ",
                    tools.energy_factor * record->path->released);
      note(text + why);
      tools.inertia.forget_velocities();
      state.dt      = parameters.smallest;
      state.last_dt = 0.;
      ++result.increments;
      pass_on(*record);
      return true;
    }



    void Controller::dynamic_phase()
    {
      IncrementParameters parameters = increments;
      parameters.state               = &state;
      weak_form.set_bulk_weight(1. - tools.integrator.alpha_f());
      const StrategyResult phase =
        run_increments(weak_form,
                       tools.path.newton,
                       parameters,
                       end_time,
                       dynamic_hooks(weak_form, tools.inertia),
                       [&](const IncrementRecord &record) {
                         calm = is_calm() ? calm + 1 : 0;
                         return pass_on(record) && calm < calm_needed;
                       });
      add(phase);
      if (phase.gave_up)
        {
          result.gave_up = true;
          result.reason  = phase.reason;
          goes_on        = false;
        }
      if (!goes_on || calm < calm_needed)
        return;
      in_phase = 0;
      note("quasi-static, because inertia forces have gone");
      tools.inertia.set_at_rest(true);
    }



    void Controller::add(const StrategyResult &phase)
    {
      result.increments += phase.increments;
      result.rejected          = phase.rejected;
      result.newton_iterations = phase.newton_iterations;
    }



    bool Controller::pass_on(const IncrementRecord &record)
    {
      ++in_phase;
      save();
      goes_on = on_accept(record);
      return goes_on;
    }



    bool Controller::is_calm() const
    {
      return tools.inertia.force_norm() <=
             no_inertia * tools.path.newton.largest_force;
    }



    void Controller::note(const std::string &event)
    {
      const Energies now = weak_form.energies();
      char           text[160];
      std::snprintf(
        text,
        sizeof(text),
        "time %.6g s (stored %.4g, kinetic %.4g, adhesion %.4g mJ): ",
        weak_form.time(),
        tools.energy_factor * now.stored,
        tools.energy_factor * tools.inertia.kinetic_energy(),
        tools.energy_factor * now.adhesion);
      result.events.push_back(text + event);
      tools.path.note(result.events.back());
    }



    void Controller::save()
    {
      state.path = {static_cast<double>(in_phase),
                    static_cast<double>(calm),
                    static_cast<double>(calm_needed),
                    static_cast<double>(to_skip),
                    static_cast<double>(skip),
                    released};
    }



    void Controller::load()
    {
      in_phase    = static_cast<unsigned int>(state.path.at(0));
      calm        = static_cast<unsigned int>(state.path.at(1));
      calm_needed = static_cast<unsigned int>(state.path.at(2));
      to_skip     = static_cast<unsigned int>(state.path.at(3));
      skip        = static_cast<unsigned int>(state.path.at(4));
      released    = state.path.at(5);
    }
  } // namespace



  StrategyResult run_automatic(WeakForm                  &weak_form,
                               const AutomaticTools      &tools,
                               const IncrementParameters &increments,
                               const double               end_time,
                               const OnAccept            &on_accept)
  {
    return Controller(weak_form, tools, increments, end_time, on_accept).run();
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// A press cycle over the thickness of a block: temperature and cure.
#include "cure/cure_cycle_task.h"

#include "base/parameter_error.h"
#include "cure/cure_cycle_output.h"
#include "output/progress.h"
#include "output/summary.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// True without MPI too: unit tests do not start it.
    bool is_first_rank()
    {
      int started = 0;
      MPI_Initialized(&started);
      return started == 0 ||
             Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    }



    /// 0 to @p end in steps of @p interval, with @p opening and the end.
    std::vector<double> output_times(const double interval,
                                     const double opening,
                                     const double end)
    {
      std::vector<double> times = {opening, end};
      for (unsigned int i = 0; i * interval < end; ++i)
        times.push_back(i * interval);
      std::sort(times.begin(), times.end());
      times.erase(std::unique(times.begin(), times.end()), times.end());
      return times;
    }



    DepthHistory history_at(const SlabHistory         &slab,
                            const double               depth,
                            const CureModel           &model,
                            const OdeTolerances       &tolerances,
                            const std::vector<double> &times)
    {
      const TemperatureHistory temperature = slab.at(depth);
      DepthHistory             history;
      history.depth = depth;
      history.state =
        integrate_cure(model, temperature, times, tolerances, CureState());
      for (std::size_t i = 0; i < times.size(); ++i)
        {
          history.temperature.push_back(temperature(times[i]));
          history.degree.push_back(degree_of_cure(model, history.state[i]));
        }
      return history;
    }



    Summary summary_of(const CureModel                 &model,
                       const OdeTolerances             &tolerances,
                       const std::size_t                opening,
                       const std::vector<DepthHistory> &profile)
    {
      Summary summary;
      summary.set("status", "completed");
      summary.set("reason", "");
      const auto &mould = profile.front(), &back = profile.back(),
                 &middle     = profile[profile.size() / 2];
      const std::size_t last = mould.degree.size() - 1;
      for (const auto &[when, i] : {std::make_pair("", last),
                                    std::make_pair(" at the opening", opening)})
        for (const auto &[where, history] :
             {std::make_pair("at the mould side", &mould),
              std::make_pair("in the middle", &middle),
              std::make_pair("at the back", &back)})
          {
            const std::string place = std::string(where) + when;
            summary.set("f90 " + place + " [-]", history->state[i].f90);
            summary.set("degree of cure " + place + " [-]", history->degree[i]);
            summary.set("temperature " + place + " [degC]",
                        history->temperature[i]);
          }
      const auto by_f90 = [last](const auto &a, const auto &b) {
        return a.state[last].f90 < b.state[last].f90;
      };
      const auto by_degree = [last](const auto &a, const auto &b) {
        return a.degree[last] < b.degree[last];
      };
      const auto range =
        std::minmax_element(profile.begin(), profile.end(), by_f90);
      const auto least =
        std::min_element(profile.begin(), profile.end(), by_degree);
      summary.set("lowest f90 [-]", range.first->state[last].f90);
      summary.set("depth of lowest f90 [mm]", range.first->depth);
      summary.set("largest f90 [-]", range.second->state[last].f90);
      summary.set("lowest degree of cure [-]", least->degree[last]);
      summary.set("depth of lowest degree of cure [mm]", least->depth);
      // 0.9, if kinetics and t90 belong to the same compound
      const double T_ref = model.t90.reference_temperature;
      summary.set("degree of cure at t90 and reference temperature [-]",
                  degree_of_cure(model,
                                 integrate_cure(model,
                                                TemperatureHistory(T_ref),
                                                {0., model.t90(T_ref)},
                                                tolerances,
                                                CureState())[1]));
      return summary;
    }
  } // namespace



  void CureCycleTask::add_parameters(ParameterHandler &prm)
  {
    cure.add_parameters(prm);
    press.add_parameters(prm);
    prm.enter_subsection("Cure cycle");
    prm.add_parameter("thickness",
                      thickness,
                      "L of the block from mould to bladder side [mm]",
                      Patterns::Double(1e-6));
    prm.add_parameter("elements",
                      n_elements,
                      "number of finite elements over the thickness [-]",
                      Patterns::Integer(2, 100000));
    prm.add_parameter("depths",
                      depths,
                      "distances from the mould side in history.csv [mm]",
                      Patterns::List(Patterns::Double(0.), 1));
    prm.add_parameter("output interval",
                      output_interval,
                      "time between rows of history.csv [s]",
                      Patterns::Double(1e-6));
    prm.leave_subsection();
  }



  void CureCycleTask::check() const
  {
    cure.check();
    press.check();
    for (const double depth : depths)
      if (depth > thickness)
        {
          std::ostringstream text;
          text << "must lie within Cure cycle/thickness = " << thickness
               << " mm; got " << depth << " mm. Leave it out.";
          throw ExcParameter("Cure cycle/depths", text.str());
        }
    const double n_rows = press.cycle().end_time / output_interval;
    if (n_rows > 1e6)
      {
        std::ostringstream text;
        text << "must give at most 1e6 rows; got " << output_interval
             << " s, which gives " << n_rows << ". Take a longer one.";
        throw ExcParameter("Cure cycle/output interval", text.str());
      }
  }



  std::string CureCycleTask::preview() const
  {
    const PressCycle   cycle = press.cycle();
    const CureModel    model = cure.model();
    std::ostringstream text;
    text << "Cure of a block of " << thickness << " mm, " << n_elements
         << " elements over the thickness, diffusivity "
         << cycle.material.diffusivity() << " mm2/s.\n"
         << "Press closed until " << cycle.opening_time
         << " s, cooling in air until " << cycle.end_time << " s.\n"
         << "t90 = " << model.t90.reference_value << " s at "
         << model.t90.reference_temperature
         << " degC, E_a = " << model.t90.activation_energy
         << " kJ/mol; degree of cure by "
         << (model.kinetics ? model.kinetics->name() :
                              std::string("the table over f90"))
         << '.';
    return text.str();
  }



  RunStatus CureCycleTask::run(const RunContext &context) const
  {
    // All of it takes less than a second: one rank does it.
    if (!is_first_rank())
      return RunStatus::completed;
    const PressCycle          cycle      = press.cycle();
    const CureModel           model      = cure.model();
    const OdeTolerances       tolerances = cure.tolerances();
    const std::vector<double> times =
      output_times(output_interval, cycle.opening_time, cycle.end_time);
    const std::size_t opening =
      std::find(times.begin(), times.end(), cycle.opening_time) - times.begin();

    const SlabHistory         slab(cycle, thickness, n_elements);
    std::vector<DepthHistory> histories, profile;
    for (const double depth : depths)
      histories.push_back(history_at(slab, depth, model, tolerances, times));
    for (unsigned int i = 0; i <= n_elements; ++i)
      profile.push_back(
        history_at(slab, thickness * i / n_elements, model, tolerances, times));

    const std::string &folder = context.output_folder;
    write_cure_history(folder, times, histories);
    write_cure_profile(folder, opening, profile);
    const Summary summary = summary_of(model, tolerances, opening, profile);
    Progress      progress(std::cout, context.quiet);
    progress.note(draw_cure_cycle(folder, histories));
    progress.print(summary);
    summary.write(folder + "/summary.json");
    return RunStatus::completed;
  }
} // namespace demold

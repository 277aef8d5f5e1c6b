// SPDX-License-Identifier: LGPL-2.1-or-later
// Heat conduction between nodes: finite elements with lumped heat capacity.
#include "cure/thermal_network.h"

#include <algorithm>
#include <utility>

namespace demold
{
  namespace
  {
    using Prescribed = std::vector<const ThermalSide *>;

    Prescribed prescribed_nodes(const ThermalNetwork           &network,
                                const std::vector<ThermalSide> &sides)
    {
      Prescribed prescribed(network.capacity.size(), nullptr);
      for (const auto &s : network.surface)
        if (sides[s.side].contact == ThermalSide::perfect &&
            prescribed[s.node] == nullptr)
          prescribed[s.node] = &sides[s.side];
      return prescribed;
    }



    void prescribe(const Prescribed    &prescribed,
                   const double         time,
                   std::vector<double> &temperatures)
    {
      for (std::size_t i = 0; i < prescribed.size(); ++i)
        if (prescribed[i] != nullptr)
          temperatures[i] = prescribed[i]->temperature(time);
    }



    /// dT/dt of the free nodes, 0 at the others, linear in the temperatures of
    /// nodes and sides.
    void heating_rate(const ThermalNetwork           &network,
                      const std::vector<ThermalSide> &sides,
                      const Prescribed               &prescribed,
                      const std::vector<double>      &side_temperatures,
                      const double                   *T,
                      double                         *rate)
    {
      const std::size_t n = network.capacity.size();
      std::fill(rate, rate + n, 0.);
      for (const auto &link : network.links)
        {
          const double flux = link.conductance * (T[link.b] - T[link.a]);
          rate[link.a] += flux;
          rate[link.b] -= flux;
        }
      for (const auto &s : network.surface)
        if (sides[s.side].contact == ThermalSide::film)
          rate[s.node] += sides[s.side].film_coefficient * s.area *
                          (side_temperatures[s.side] - T[s.node]);
      for (std::size_t i = 0; i < n; ++i)
        rate[i] = prescribed[i] == nullptr ? rate[i] / network.capacity[i] : 0.;
    }



    std::vector<double> breakpoints(const std::vector<ThermalSide> &sides,
                                    const double                    start,
                                    const double                    end)
    {
      std::vector<double> stops = {end};
      for (const auto &side : sides)
        if (side.contact != ThermalSide::insulated)
          for (const double t : side.temperature.breakpoints)
            if (t > start && t < end)
              stops.push_back(t);
      std::sort(stops.begin(), stops.end());
      stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
      return stops;
    }



    /// The equations of the free nodes. Prescribed nodes have no equation:
    /// their temperature is put in wherever they are read.
    OdeProblem heat_problem(const ThermalNetwork           &network,
                            const std::vector<ThermalSide> &sides,
                            const Prescribed               &prescribed)
    {
      const std::size_t n = network.capacity.size();
      OdeProblem        problem;
      problem.rate = [&, n, T = std::vector<double>(n)](const double  t,
                                                        const double *y,
                                                        double *rate) mutable {
        T.assign(y, y + n);
        prescribe(prescribed, t, T);
        std::vector<double> outside;
        for (const auto &side : sides)
          outside.push_back(side.temperature(t));
        heating_rate(network, sides, prescribed, outside, T.data(), rate);
      };
      problem.jacobian_times =
        [&, n, T = std::vector<double>(n)](const double,
                                           const double *v,
                                           double       *Jv) mutable {
          for (std::size_t i = 0; i < n; ++i)
            T[i] = prescribed[i] == nullptr ? v[i] : 0.;
          heating_rate(network,
                       sides,
                       prescribed,
                       std::vector<double>(sides.size(), 0.),
                       T.data(),
                       Jv);
        };
      return problem;
    }
  } // namespace



  double ThermalStep::temperature(const unsigned int node,
                                  const double       time) const
  {
    if (prescribed[node] != nullptr)
      return prescribed[node]->temperature(time);
    const double h = end - start, x = (time - start) / h;
    const double rise = T_end[node] - T_start[node];
    // Hermite's cubic as a straight line and what bends it
    return T_start[node] + x * rise +
           x * (1. - x) *
             ((1. - x) * (h * rate_start[node] - rise) -
              x * (h * rate_end[node] - rise));
  }



  void conduct_heat(const ThermalNetwork           &network,
                    const std::vector<ThermalSide> &sides,
                    const double                    start,
                    const double                    end,
                    const OdeTolerances            &tolerances,
                    std::vector<double>            &temperatures,
                    const std::function<void(const ThermalStep &)> &on_step)
  {
    const Prescribed prescribed = prescribed_nodes(network, sides);
    const OdeProblem problem    = heat_problem(network, sides, prescribed);
    const auto       rates = [&](const double t, const std::vector<double> &T) {
      std::vector<double> rate(T.size());
      problem.rate(t, T.data(), rate.data());
      return rate;
    };

    ThermalStep step;
    step.prescribed = prescribed;
    step.end        = start;
    step.T_end      = temperatures;
    for (const double stop : breakpoints(sides, start, end))
      {
        // What the sides do may jump at a breakpoint, so start afresh.
        OdeSolver solver(problem, step.end, step.T_end, tolerances);
        step.rate_end = rates(step.end, step.T_end);
        while (solver.time() < stop)
          {
            solver.step(stop);
            step.start      = step.end;
            step.T_start    = std::move(step.T_end);
            step.rate_start = std::move(step.rate_end);
            step.end        = solver.time();
            step.T_end      = solver.state();
            step.rate_end   = rates(step.end, step.T_end);
            on_step(step);
          }
      }
    temperatures = step.T_end;
    prescribe(prescribed, end, temperatures);
  }
} // namespace demold

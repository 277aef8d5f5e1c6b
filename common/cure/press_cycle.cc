// SPDX-License-Identifier: LGPL-2.1-or-later
// A press cycle through the thickness of a block: heat in one dimension.
#include "cure/press_cycle.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  ThermalNetwork slab_network(const ThermalMaterial &material,
                              const double           thickness,
                              const unsigned int     n_elements)
  {
    const double   h = thickness / n_elements;
    ThermalNetwork network;
    network.capacity.assign(n_elements + 1, material.heat_capacity * h);
    network.capacity.front() *= .5;
    network.capacity.back() *= .5;
    for (unsigned int e = 0; e < n_elements; ++e)
      network.links.push_back({e, e + 1, material.conductivity / h});
    network.surface = {{0, 0, 1.}, {n_elements, 1, 1.}};
    return network;
  }



  SlabHistory::SlabHistory(const PressCycle  &cycle,
                           const double       thickness,
                           const unsigned int n_elements)
    : thickness(thickness)
    , n_elements(n_elements)
    , pressed({cycle.mould, cycle.bladder})
    , opened({cycle.air, cycle.air})
  {
    const ThermalNetwork network =
      slab_network(cycle.material, thickness, n_elements);
    std::vector<double> T(n_elements + 1, cycle.initial_temperature);
    const auto   keep    = [this](const ThermalStep &s) { steps.push_back(s); };
    const double opening = std::min(cycle.opening_time, cycle.end_time);
    conduct_heat(network, pressed, 0., opening, cycle.tolerances, T, keep);
    if (opening < cycle.end_time)
      conduct_heat(network,
                   opened,
                   opening,
                   cycle.end_time,
                   cycle.tolerances,
                   T,
                   keep);

    breakpoints = {opening, cycle.end_time};
    for (const auto *side : {&cycle.mould, &cycle.bladder, &cycle.air})
      breakpoints.insert(breakpoints.end(),
                         side->temperature.breakpoints.begin(),
                         side->temperature.breakpoints.end());
    std::sort(breakpoints.begin(), breakpoints.end());
  }



  double SlabHistory::temperature(const unsigned int node,
                                  const double       time) const
  {
    const auto step =
      std::lower_bound(steps.begin(),
                       steps.end() - 1,
                       time,
                       [](const ThermalStep &s, const double t) {
                         return s.end < t;
                       });
    return step->temperature(node, time);
  }



  TemperatureHistory SlabHistory::at(const double depth) const
  {
    const double       x = depth / thickness * n_elements;
    const unsigned int e =
      std::min(static_cast<unsigned int>(std::max(std::floor(x), 0.)),
               n_elements - 1);
    const double share = x - e;
    return TemperatureHistory(
      [this, e, share](const double t) {
        return (share < 1. ? (1. - share) * temperature(e, t) : 0.) +
               (share > 0. ? share * temperature(e + 1, t) : 0.);
      },
      breakpoints);
  }
} // namespace demold

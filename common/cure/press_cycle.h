// SPDX-License-Identifier: LGPL-2.1-or-later
// A press cycle through the thickness of a block: heat in one dimension.
#ifndef demold_cure_press_cycle_h
#define demold_cure_press_cycle_h

#include "cure/thermal_network.h"

#include <vector>

namespace demold
{
  /// Heat conduction in rubber; the numbers are those in W/(m K), MJ/(m^3 K).
  struct ThermalMaterial
  {
    double conductivity  = 0.27; ///< k [N/(s K)]
    double heat_capacity = 2.25; ///< rho c_p per volume [MPa/K]

    /// a = k/(rho c_p) [mm^2/s].
    double diffusivity() const
    {
      return conductivity / heat_capacity;
    }
  };

  /// What happens to a block: heated in the press, then cooled in air.
  struct PressCycle
  {
    ThermalMaterial material;
    double          initial_temperature = 30.; ///< of the block [degC]
    ThermalSide     mould;                     ///< in the press
    ThermalSide     bladder;                   ///< in the press, the back
    double          opening_time = 600.;       ///< [s]
    double          end_time     = 900.;       ///< [s]
    ThermalSide     air;                       ///< on both sides afterwards
    OdeTolerances   tolerances = {1e-6, 1e-3}; ///< of the temperature
  };

  /// Temperatures of a slab over the time of a press cycle.
  class SlabHistory
  {
  public:
    /// @p thickness [mm] divided into @p n_elements linear elements.
    SlabHistory(const PressCycle  &cycle,
                const double       thickness,
                const unsigned int n_elements);

    SlabHistory(const SlabHistory &) = delete;

    /// T(t) [degC] at @p depth [mm], 0 at the mould side; not to outlive this.
    TemperatureHistory at(const double depth) const;

    const double             thickness;   ///< [mm]
    const unsigned int       n_elements;  ///< [-]
    std::vector<ThermalStep> steps;       ///< of the integrator, in order
    std::vector<double>      breakpoints; ///< [s]

  private:
    /// @p node at @p time: the first step that reaches it.
    double temperature(const unsigned int node, const double time) const;

    // The steps point to the sides.
    std::vector<ThermalSide> pressed, opened;
  };

  /// The network of a slab per mm^2: side 0 at node 0, side 1 at the last.
  ThermalNetwork slab_network(const ThermalMaterial &material,
                              const double           thickness,
                              const unsigned int     n_elements);
} // namespace demold

#endif

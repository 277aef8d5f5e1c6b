// SPDX-License-Identifier: LGPL-2.1-or-later
// Heat conduction between nodes: finite elements with lumped heat capacity.
#ifndef demold_cure_thermal_network_h
#define demold_cure_thermal_network_h

#include "cure/ode_solver.h"
#include "cure/temperature_history.h"

#include <functional>
#include <vector>

namespace demold
{
  /// What touches a part of the surface.
  struct ThermalSide
  {
    enum Contact
    {
      perfect,  ///< the surface has the temperature of the side
      film,     ///< heat flux = film coefficient times difference (Robin)
      insulated ///< no heat flux: symmetry
    };

    Contact            contact = insulated;
    TemperatureHistory temperature;
    double film_coefficient = 0.; ///< h [N/(mm s K)], 1e-3 of W/(m^2 K)
  };

  /// The body, whatever its dimension: nodes with heat capacity, linked by
  /// conductances. Linear finite elements give it, because the rows of their
  /// conductivity matrix sum to zero: c_i dT_i/dt = sum_j g_ij (T_j - T_i).
  /// Heat is conserved exactly.
  struct ThermalNetwork
  {
    /// g = minus the entry (a, b) of the conductivity matrix [mJ/(s K)].
    struct Link
    {
      unsigned int a, b;
      double       conductance;
    };

    /// A node on a side, with the area it has there [mm^2].
    struct SurfaceNode
    {
      unsigned int node;
      unsigned int side;
      double       area;
    };

    std::vector<double>      capacity; ///< of each node [mJ/K]
    std::vector<Link>        links;
    std::vector<SurfaceNode> surface;
  };

  /// Temperatures over one accepted step: cubic in time (Hermite), and what
  /// the side prescribes at nodes in perfect contact.
  struct ThermalStep
  {
    double                           start, end;           ///< [s]
    std::vector<double>              T_start, T_end;       ///< [degC]
    std::vector<double>              rate_start, rate_end; ///< dT/dt [K/s]
    std::vector<const ThermalSide *> prescribed; ///< per node; null: free

    double temperature(const unsigned int node, const double time) const;
  };

  /// Conducts heat from time @p start to @p end with ARKODE and calls
  /// @p on_step after every step. @p temperatures [degC] are those of the nodes
  /// before and after. Where two sides in perfect contact share a node, the
  /// first in network.surface holds.
  void conduct_heat(const ThermalNetwork           &network,
                    const std::vector<ThermalSide> &sides,
                    const double                    start,
                    const double                    end,
                    const OdeTolerances            &tolerances,
                    std::vector<double>            &temperatures,
                    const std::function<void(const ThermalStep &)> &on_step);
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Network: nodes, springs, bars and bonds without a mesh.
#ifndef demold_scene_network_entries_h
#define demold_scene_network_entries_h

#include <deal.II/base/point.h>

#include <map>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// A network as a list of what it consists of; nodes by number.
  struct Network
  {
    struct Component
    {
      unsigned int node, direction; ///< 0: x, 1: y
      double       sign = 1.;
    };
    struct SpringEntry
    {
      unsigned int a, b, direction;
      double       stiffness; ///< [N/mm]
    };
    struct LinkEntry
    {
      unsigned int a, b;
      double       size; ///< EA [N] of a bar, area [mm^2] of a bond
    };

    std::vector<dealii::Point<2>> nodes; ///< [mm]
    std::vector<Component>        held, driven, loaded, opening;
    std::vector<SpringEntry>      springs;
    std::vector<LinkEntry>        bars, bonds;

    /// Numbers of the displacements that something pulls at, by 2 node +
    /// direction; all others are none, even if they are held.
    std::map<unsigned int, unsigned int> unknowns() const;
  };

  /// The entries as typed.
  struct NetworkEntries
  {
    std::string nodes, held, driven, loaded, springs, bars, bonds;
    std::string motion = "0"; ///< [mm]
    std::string load   = "0"; ///< [N]
    std::string opening;
    double      end_time = 1.; ///< [s]

    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws ExcParameter where an entry cannot be understood.
    Network network() const;
  };
} // namespace demold

#endif

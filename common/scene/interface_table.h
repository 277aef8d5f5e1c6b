// SPDX-License-Identifier: LGPL-2.1-or-later
// interface.csv: a row per slave point, as the run has left it.
#ifndef demold_scene_interface_table_h
#define demold_scene_interface_table_h

#include <string>

namespace demold
{
  class InterfaceTerm;

  /// Writes the slave points of all ranks to @p file, ordered by reference
  /// position x, then y, then z; collective. Columns: that position, nodal
  /// area, gap (empty: nothing near), pressure (compression positive), force
  /// of the mould on the rubber (contact, friction and bond), damage kappa
  /// over rupture gap (1: no bond), whether it is bonded, state of theory C.5
  /// (0 to 5; 6: free) and the time of separation (empty: never). A reduced
  /// model lists the points it has.
  void write_interface_table(const std::string   &file,
                             const InterfaceTerm &interface);
} // namespace demold

#endif

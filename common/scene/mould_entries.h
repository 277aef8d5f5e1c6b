// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Mould: a rigid plane or a polyline drawn by its corners.
#ifndef demold_scene_mould_entries_h
#define demold_scene_mould_entries_h

#include "geometry/rigid_surface.h"

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  struct MouldEntries
  {
    std::string shape  = "plane"; ///< | none | polyline
    std::string from   = "-100, -100";
    std::string to     = "100, 100";
    double      level  = 0.; ///< [mm]
    std::string facets = "20, 20";
    std::string corners; ///< of a polyline

    void add_parameters(dealii::ParameterHandler &prm);

    /// The surface, for a shape other than none; @p dim 2 or 3.
    RigidSurface surface(int dim) const;
  };
} // namespace demold

#endif

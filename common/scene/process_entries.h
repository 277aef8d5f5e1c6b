// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections Process and Pull: who moves, and where the force is measured.
#ifndef demold_scene_process_entries_h
#define demold_scene_process_entries_h

#include "scene/pull.h"
#include "scene/scene.h"

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Either the mould moves (section Pull) or a grip does (the motion of the
  /// supports), which then says what its opening and its direction are.
  struct ProcessEntries
  {
    std::string moved_by  = "mould"; ///< | grip
    double      end_time  = 1.;      ///< [s]
    std::string opening   = "0";     ///< formula in t [mm]
    std::string direction = "0, 1, 0";
    std::string force_on  = "mould"; ///< | supports | a boundary
    Pull        pull;

    void add_parameters(dealii::ParameterHandler &prm);

    /// Motion, opening and force of @p scene, which is not to outlive this.
    template <int dim>
    void set_process(Scene<dim> &scene) const;
  };
} // namespace demold

#endif

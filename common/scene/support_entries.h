// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Supports: what is held, what is driven, what is loaded.
#ifndef demold_scene_support_entries_h
#define demold_scene_support_entries_h

#include "scene/scene.h"

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Boundaries with components, such as "top xy, left x".
  struct SupportEntries
  {
    /// auto holds the top, unless something is driven.
    std::string                held = "auto";
    std::string                driven;
    std::string                driven_where = "1";
    std::array<std::string, 3> motion{{"0", "0", "0"}}; ///< formulas [mm]
    std::string                traction_boundary;       ///< empty: none
    std::string                traction = "0, 0, 0";    ///< formulas [MPa]

    void add_parameters(dealii::ParameterHandler &prm);

    /// A rule per component, driven ones first.
    template <int dim>
    std::vector<SupportRule> supports() const;

    std::vector<TractionRule> tractions() const;
  };
} // namespace demold

#endif

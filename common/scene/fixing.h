// SPDX-License-Identifier: LGPL-2.1-or-later
// What holds the back of a tread block.
#ifndef demold_scene_fixing_h
#define demold_scene_fixing_h

#include "material/ply_parameters.h"
#include "material/rubber_law.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Section Block, entry fixing, and the sections of the layers behind it.
  ///
  /// * rigid plate: the backing is held in all directions.
  /// * belt plies: cord-rubber plies, a layer each. While the mould opens, the
  ///   grip holds the back of the belt along the opening only; in its plane
  ///   the cords hold it, and the belt goes on beyond the block: its sides
  ///   stay in their planes, as in a row of equal blocks.
  /// * rubber base: elastic rubber of its own modulus, held at its back.
  struct Fixing
  {
    std::string    kind = "rigid plate";
    BeltParameters belt;
    double         base_thickness = 2.;  ///< [mm]
    double         base_modulus   = 3.;  ///< E [MPa]
    double         base_bulk      = 50.; ///< K [MPa]

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;

    /// Thicknesses [mm] from the block outwards; layer k has material id k + 1.
    std::vector<double> layers() const;
    RubberLaw           law(unsigned int layer, int dim) const;

    /// The fixing holds the back; what stands on a symmetry plane stays on it.
    template <int dim>
    std::vector<SupportRule> supports() const;
  };
} // namespace demold

#endif

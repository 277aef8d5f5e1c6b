// SPDX-License-Identifier: LGPL-2.1-or-later
// A box in a parameter file, as the body or as the base below it.
#ifndef demold_scene_box_entries_h
#define demold_scene_box_entries_h

#include "geometry/test_bodies.h"

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Lists of numbers, one per direction. Two numbers do in two dimensions.
  struct BoxEntries
  {
    std::string corner; ///< smallest coordinates [mm]
    std::string size;   ///< [mm]
    std::string cells;  ///< per direction
    std::string grading      = "1, 1, 1";
    double      irregularity = 0.; ///< of the nodes inside [-]

    /// Into the section that is entered.
    void add_parameters(dealii::ParameterHandler &prm);

    /// @param section   for messages
    /// @param material  id of its cells
    template <int dim>
    Box<dim> box(const std::string &section, unsigned int material) const;
  };
} // namespace demold

#endif

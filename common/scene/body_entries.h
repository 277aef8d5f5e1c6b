// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections Body and Base: the rubber body and a second one below it.
#ifndef demold_scene_body_entries_h
#define demold_scene_body_entries_h

#include "geometry/boundary_names.h"
#include "scene/box_entries.h"

#include <set>
#include <string>

namespace dealii
{
  class ParameterHandler;
  template <int dim, int spacedim>
  class Triangulation;
} // namespace dealii

namespace demold
{
  /// A box or a half cylinder, alone or with a box below, the base.
  struct BodyEntries
  {
    std::string  shape = "box"; ///< | half cylinder
    BoxEntries   body{"0, 0, 0", "10, 10, 10", "8, 8, 8"};
    HalfCylinder cylinder;
    std::string  slave    = "bottom"; ///< boundaries that may touch
    bool         has_base = false;
    BoxEntries   base{"-2, -4, -4", "14, 4, 4", "11, 3, 3"};

    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws ExcParameter if a box cannot be what the entries say.
    template <int dim>
    void check() const;

    /// Fills an empty triangulation; the base has material id 1.
    template <int dim>
    void make_mesh(dealii::Triangulation<dim, dim> &triangulation) const;

    /// Height [mm] of the body over its slave boundaries.
    template <int dim>
    double height() const;

    std::set<Boundary::Id> slave_boundaries() const;
  };
} // namespace demold

#endif

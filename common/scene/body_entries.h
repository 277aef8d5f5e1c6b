// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections Body and Base: the rubber body and a second one below it.
#ifndef demold_scene_body_entries_h
#define demold_scene_body_entries_h

#include "geometry/boundary_names.h"
#include "material/rubber_law.h"
#include "scene/box_entries.h"

#include <deal.II/base/types.h>

#include <map>
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
  /// A box, one that is fine in a part of its bottom, or a half cylinder; the
  /// first and the last also with a box below, the base.
  struct BodyEntries
  {
    std::string  shape = "box"; ///< | graded box | half cylinder
    BoxEntries   body{"0, 0, 0", "10, 10, 10", "8, 8, 8"};
    HalfCylinder cylinder;         ///< its fine zone is also of a graded box
    double       fine_centre = 0.; ///< of a graded box, x [mm]
    std::string  slave       = "bottom"; ///< boundaries that may touch
    bool         has_base    = false;
    BoxEntries   base{"-2, -4, -4", "14, 4, 4", "11, 3, 3"};
    std::string  interface    = "0"; ///< height over its plane, formula [mm]
    double       base_modulus = 0.;  ///< E [MPa]; 0: rubber of the body
    double       base_bulk    = 50.; ///< K [MPa]

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

    /// What they touch if there is a base: its top, or, for slaves of the
    /// base, the bottom of the body.
    std::set<Boundary::Id> master_boundaries() const;

    /// Laws by material id of what is not of the rubber of section Material.
    std::map<dealii::types::material_id, RubberLaw> laws() const;

  private:
    GradedBox graded_box() const;

    /// Body and base as boxes that meet at the interface.
    template <int dim>
    Box<dim> upper() const;
    template <int dim>
    Box<dim> lower() const;
  };
} // namespace demold

#endif

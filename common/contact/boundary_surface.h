// SPDX-License-Identifier: LGPL-2.1-or-later
// The faces of the rubber that may touch: nodes, unknowns, facets.
#ifndef demold_contact_boundary_surface_h
#define demold_contact_boundary_surface_h

#include "contact/facet.h"

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <array>
#include <set>
#include <vector>

namespace dealii
{
  template <int dim, int spacedim>
  class DoFHandler;
}

namespace demold
{
  /// Boundary faces of a mesh as facets over nodes, the same on every rank.
  /// A quadratic face is split into linear facets over all its nodes.
  struct BoundarySurface
  {
    struct Node
    {
      dealii::Point<3> X; ///< [mm] reference position
      /// Unknowns of the displacement; entries from dim on are unused.
      std::array<dealii::types::global_dof_index, 3> unknowns;
    };

    std::vector<Node>   nodes;
    std::vector<Facet>  facets; ///< normals out of the rubber
    std::vector<double> height; ///< [mm] of the cell behind each facet

    /// Quadratic elements: the 3^(dim-1) nodes of each face, line by line.
    /// Its 2^(dim-1) facets follow each other. Empty for linear elements,
    /// whose faces are the facets.
    std::vector<std::vector<unsigned int>> quadratic_faces;

    /// Reference positions of all nodes.
    std::vector<dealii::Point<3>> positions() const;
  };

  /// Collects the faces with one of @p boundary_ids, in the order of the
  /// cells.
  template <int dim>
  BoundarySurface
  extract_surface(const dealii::DoFHandler<dim, dim>         &dof_handler,
                  const std::set<dealii::types::boundary_id> &boundary_ids);
} // namespace demold

#endif

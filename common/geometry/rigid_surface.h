// SPDX-License-Identifier: LGPL-2.1-or-later
// The surface of a rigid mould as oriented facets in smooth patches.
#ifndef demold_geometry_rigid_surface_h
#define demold_geometry_rigid_surface_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace demold
{
  /// A rigid surface of quadrilaterals (3-D) or of segments in the x-y plane
  /// (2-D, third coordinate 0), in the position it has when the mould is
  /// closed. Vertices are shared between neighbouring facets, also across
  /// sharp edges: split by @ref patch before averaging normals.
  ///
  /// Orientation: the facet normal points out of the metal, into the rubber.
  /// - 3-D: vertices run counter-clockwise seen from the rubber,
  ///   n ~ (v1 - v0) x (v3 - v0);
  /// - 2-D: n = t x e_z = (t_y, -t_x) with t from vertex 0 to vertex 1.
  struct RigidSurface
  {
    struct Facet
    {
      /// Indices into vertices; entries from n on are unused (0).
      std::array<unsigned int, 4> v;
      /// Number of vertices: 2 in 2-D, 4 in 3-D.
      unsigned int n;
    };

    /// Positions [mm].
    std::vector<dealii::Point<3>> vertices;
    std::vector<Facet>            facets;
    /// One number per facet; facets of one patch that share an edge meet
    /// smoothly.
    std::vector<unsigned int> patch;
  };

  /// Unit normal at the centre of a facet [-], out of the metal.
  dealii::Tensor<1, 3> facet_normal(const RigidSurface &surface,
                                    unsigned int        facet);

  /// Length [mm] of a 2-D facet, area [mm^2] of a 3-D facet (exact if the
  /// facet is plane).
  double facet_area(const RigidSurface &surface, unsigned int facet);

  /// Mean of the vertices of a facet [mm].
  dealii::Point<3> facet_centre(const RigidSurface &surface,
                                unsigned int        facet);

  /// Sum of facet_area over all facets [mm] or [mm^2].
  double surface_area(const RigidSurface &surface);

  /// Add the facets of @p other; its patches are renumbered to stay apart.
  void append_surface(RigidSurface &surface, const RigidSurface &other);
} // namespace demold

#endif

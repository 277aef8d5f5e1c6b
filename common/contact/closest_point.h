// SPDX-License-Identifier: LGPL-2.1-or-later
// Closest point of a slave node on a master facet and on a master surface.
#ifndef demold_contact_closest_point_h
#define demold_contact_closest_point_h

#include "contact/contact_surface.h"
#include "contact/facet.h"

#include <array>
#include <optional>
#include <vector>

namespace demold
{
  /// Foot of a point on one facet, continued beyond its edges.
  struct Projection
  {
    bool                 found = false; ///< did the iteration converge?
    FacetCoordinates     xi{};
    dealii::Point<3>     x;       ///< [mm] the foot
    dealii::Tensor<1, 3> normal;  ///< outward unit normal there
    double               gap = 0; ///< [mm] n . (point - foot), > 0 open
  };

  /// Solves thesis (3.5) by Newton's method (3.6) from the centre of the
  /// facet. Steps follow descent of the distance, so that the foot is a
  /// nearest, never a farthest point. Not found: no convergence in 20
  /// iterations, a foot beyond |xi| = 10, or a facet without area.
  Projection project(const dealii::Point<3> &point,
                     const FacetPositions   &facet);

  /// On what the closest point lies.
  enum class ContactCase
  {
    face,
    edge,
    vertex
  };

  /// The closest point found for a slave node.
  struct ContactPoint
  {
    ContactCase                 kind;
    unsigned int                facet;   ///< it lies on (or at its border)
    unsigned int                n_nodes; ///< face 4 (2-D: 2), edge 2, vertex 1
    std::array<unsigned int, 4> nodes{};
    unsigned int                edge = 0; ///< of the surface; edges only
    FacetCoordinates            xi{};     ///< edge: xi[0] only; vertex: none
    double                      gap;      ///< [mm] > 0 open, < 0 penetration
    /// Face: the normal. Edge, vertex: (weighted) mean of the normals of the
    /// facets around; its side decides the sign of the gap.
    dealii::Tensor<1, 3> mean_normal;
  };

  /// Which distances count as contact candidates; both > 0.
  struct ContactLimits
  {
    double search_distance; ///< [mm] largest open gap
    double depth;           ///< [mm] deepest penetration; keep it below half
                            ///< the thickness of the thinnest master body
  };

  /// Cosine between slave and master normal above which they do not oppose
  /// each other (theory B.0).
  constexpr double opposed_normals = -0.2;

  /// Finds the closest point of the slave node at @p x_s with outward normal
  /// @p n_s on @p surface, looking at the facets in @p candidates
  /// (ascending). Thesis 3.1.6 with theory B.11:
  ///
  /// - faces whose normal opposes n_s and that hold the foot inside (or less
  ///   than free_end_tolerance off a free end): the smallest |gap| wins; equal
  ///   ones: @p last_facet, else the smallest number;
  /// - otherwise the nearest of the shared edges and of the interior vertices.
  ///   It must be the closest point of all facets that meet there, opposing or
  ///   not. It also wins over an open face that is farther away if the node
  ///   lies inside the body there: that face is seen through the body. A face
  ///   that is touched within round-off is not.
  ///
  /// Nothing outside -depth <= gap <= search_distance is returned.
  std::optional<ContactPoint>
  find_contact(const dealii::Point<3>          &x_s,
               const dealii::Tensor<1, 3>      &n_s,
               const ContactSurface            &surface,
               const std::vector<unsigned int> &candidates,
               const unsigned int               last_facet,
               const ContactLimits             &limits);

  /// Projects again onto the same face, edge or vertex after something has
  /// moved, without asking whether the foot is inside or another pairing is
  /// better: for frozen pairings. Empty if the projection fails.
  std::optional<ContactPoint> project_again(const ContactPoint     &old,
                                            const dealii::Point<3> &x_s,
                                            const ContactSurface   &surface);
} // namespace demold

#endif

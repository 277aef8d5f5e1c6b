// SPDX-License-Identifier: LGPL-2.1-or-later
// Choice of the closest point among faces, edges and vertices.
#include "contact/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr double tie_tolerance = 1e-9; // of gap and facet size

    /// What find_contact() was asked.
    struct Query
    {
      const Point<3>                  &x;
      const Tensor<1, 3>              &normal;
      const ContactSurface            &surface;
      const std::vector<unsigned int> &candidates;
      const unsigned int               last_facet;
      const ContactLimits             &limits;

      bool opposes(const Tensor<1, 3> &master_normal) const
      {
        return normal * master_normal < opposed_normals;
      }

      double reach() const
      {
        return std::max(limits.depth, limits.search_distance);
      }

      bool admits(const double gap) const
      {
        return -limits.depth <= gap && gap <= limits.search_distance;
      }
    };

    /// Is the foot on the facet, or just off a free end?
    bool is_inside(const FacetCoordinates &xi,
                   const unsigned int      f,
                   const ContactSurface   &surface)
    {
      const bool is_line = surface.facet(f).n_nodes == 2;
      // Edge that xi[a] passes on its negative and positive side.
      constexpr unsigned int face_edges[2][2] = {{3, 1}, {0, 2}};
      for (unsigned int a = 0; a < (is_line ? 1 : 2); ++a)
        {
          const unsigned int side = xi[a] > 0. ? 1 : 0;
          const unsigned int e    = is_line ? side : face_edges[a][side];
          const bool         is_free =
            !surface.edges()[surface.facet_edge(f, e)].is_shared();
          if (std::abs(xi[a]) >
              1. + (is_free ? free_end_tolerance : inside_tolerance))
            return false;
        }
      return true;
    }

    ContactPoint face_contact(const unsigned int    f,
                              const Projection     &foot,
                              const ContactSurface &surface)
    {
      ContactPoint point;
      point.kind        = ContactCase::face;
      point.facet       = f;
      point.n_nodes     = surface.facet(f).n_nodes;
      point.nodes       = surface.facet(f).nodes;
      point.xi          = foot.xi;
      point.gap         = foot.gap;
      point.mean_normal = foot.normal;
      return point;
    }

    std::optional<ContactPoint> nearest_face(const Query &query)
    {
      std::vector<ContactPoint> faces;
      double                    bound = std::numeric_limits<double>::max();
      for (const unsigned int f : query.candidates)
        {
          const FacetBound &ball = query.surface.bound(f);
          if (!ball.may_hold_foot(query.x, query.reach()) ||
              (ball.is_plane && !query.opposes(ball.normal)))
            continue;
          const auto facet = query.surface.facet_positions(f);
          const auto foot  = project(query.x, facet);
          if (!foot.found || !query.opposes(foot.normal) ||
              !query.admits(foot.gap) || !is_inside(foot.xi, f, query.surface))
            continue;
          faces.push_back(face_contact(f, foot, query.surface));
          const double size = (facet.x[facet.n_nodes / 2] - facet.x[0]).norm();
          const double gap  = std::abs(foot.gap);
          bound = std::min(bound, gap + tie_tolerance * (gap + size));
        }
      const ContactPoint *best = nullptr;
      for (const ContactPoint &face : faces)
        if (std::abs(face.gap) <= bound &&
            (best == nullptr || face.facet == query.last_facet))
          best = &face;
      if (best == nullptr)
        return {};
      return *best;
    }

    /// @p number of the edge or of the vertex.
    ContactPoint border_contact(const ContactCase     kind,
                                const unsigned int    number,
                                const BorderFoot     &foot,
                                const ContactSurface &surface)
    {
      const bool   is_edge = kind == ContactCase::edge;
      const auto   nodes   = is_edge ? surface.edges()[number].nodes :
                                       std::array<unsigned int, 2>{{number, 0}};
      ContactPoint point;
      point.kind        = kind;
      point.facet       = is_edge ? surface.edges()[number].facets.front() :
                                    surface.facets_at_node(number).front();
      point.edge        = is_edge ? number : 0;
      point.n_nodes     = is_edge ? 2 : 1;
      point.nodes       = {{nodes[0], nodes[1], 0, 0}};
      point.xi          = {{foot.xi, 0.}};
      point.gap         = foot.gap();
      point.mean_normal = foot.mean_normal;
      return point;
    }

    /// The nearest admissible shared edge or interior vertex of the
    /// candidates that is nearer than @p reach [mm].
    std::optional<ContactPoint> nearest_border(const Query &query, double reach)
    {
      std::optional<ContactPoint> best;
      const ContactSurface       &surface  = query.surface;
      const auto                  consider = [&](const ContactCase  kind,
                                const unsigned int number,
                                const BorderFoot  &foot) {
        const double distance = std::abs(foot.gap());
        if (!foot.is_nearest || !query.admits(foot.gap()) ||
            distance >= (1. - tie_tolerance) * reach ||
            !(foot.smallest_cosine < opposed_normals ||
              query.opposes(foot.mean_normal)))
          return;
        best  = border_contact(kind, number, foot, surface);
        reach = distance;
      };
      for (const unsigned int f : query.candidates)
        for (unsigned int e = 0; e < 4 && surface.n_dimensions() == 3; ++e)
          {
            const unsigned int edge = surface.facet_edge(f, e);
            if (surface.edges()[edge].is_shared() &&
                surface.distance_bound(surface.edges()[edge].nodes, query.x) <
                  reach)
              consider(ContactCase::edge,
                       edge,
                       surface.edge_foot(edge, query.x, query.normal));
          }
      for (const unsigned int f : query.candidates)
        for (unsigned int i = 0; i < surface.facet(f).n_nodes; ++i)
          {
            const unsigned int node = surface.facet(f).nodes[i];
            if (surface.is_interior(node) &&
                surface.distance_bound({{node, node}}, query.x) < reach)
              consider(ContactCase::vertex,
                       node,
                       surface.vertex_foot(node, query.x, query.normal));
          }
      return best;
    }
  } // namespace

  std::optional<ContactPoint>
  find_contact(const Point<3>                  &x_s,
               const Tensor<1, 3>              &n_s,
               const ContactSurface            &surface,
               const std::vector<unsigned int> &candidates,
               const unsigned int               last_facet,
               const ContactLimits             &limits)
  {
    const Query query{x_s, n_s, surface, candidates, last_facet, limits};
    const auto  face = nearest_face(query);
    // What touches within round-off is not seen through a body, though an edge
    // of the facet may be nearer by a digit, and on the other side.
    if (face && face->gap <= tie_tolerance * surface.bound(face->facet).radius)
      return face;
    const double all    = 2. * std::max(limits.search_distance, limits.depth);
    const auto   border = nearest_border(query, face ? face->gap : all);
    if (face && !(border && border->gap < 0.))
      return face;
    return border;
  }

  std::optional<ContactPoint> project_again(const ContactPoint   &old,
                                            const Point<3>       &x_s,
                                            const ContactSurface &surface)
  {
    if (old.kind == ContactCase::edge)
      return border_contact(old.kind,
                            old.edge,
                            surface.edge_foot(old.edge, x_s, {}),
                            surface);
    if (old.kind == ContactCase::vertex)
      return border_contact(old.kind,
                            old.nodes[0],
                            surface.vertex_foot(old.nodes[0], x_s, {}),
                            surface);
    const auto foot = project(x_s, surface.facet_positions(old.facet));
    if (!foot.found)
      return {};
    return face_contact(old.facet, foot, surface);
  }
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Topology of a contact surface: edges, free ends, facets around nodes.
#include "contact/contact_surface.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Position of node @p i within the facet.
    unsigned int local_number(const Facet &facet, const unsigned int i)
    {
      return std::find(facet.nodes.begin(),
                       facet.nodes.begin() + facet.n_nodes,
                       i) -
             facet.nodes.begin();
    }

    /// Nodes of edge @p e in the sense of rotation of the facet.
    std::array<unsigned int, 2> edge_nodes(const Facet       &facet,
                                           const unsigned int e)
    {
      if (facet.n_nodes == 2)
        return {{facet.nodes[e], facet.nodes[e]}};
      return {{facet.nodes[e], facet.nodes[(e + 1) % 4]}};
    }

    /// Coordinates in a four-node facet of the point @p t of its edge @p e,
    /// t running from -1 to 1 in the sense of rotation.
    FacetCoordinates on_edge(const unsigned int e, const double t)
    {
      const std::array<FacetCoordinates, 4> xi{
        {{{t, -1.}}, {{1., t}}, {{-t, 1.}}, {{-1., -t}}}};
      return xi[e];
    }

    /// Does @p d lead from the border of a facet towards its inside, which
    /// lies along @p inward? Then the border is not the closest point.
    bool leads_inside(const Tensor<1, 3> &d, const Tensor<1, 3> &inward)
    {
      return d * inward > 1e-9 * inward.norm_square();
    }
  } // namespace

  ContactSurface::ContactSurface(std::vector<Facet>    facets,
                                 std::vector<Point<3>> positions)
    : all_facets(std::move(facets))
    , x(std::move(positions))
    , facets_of_node(x.size())
  {
    check_facets();
    for (unsigned int f = 0; f < n_facets(); ++f)
      for (unsigned int i = 0; i < all_facets[f].n_nodes; ++i)
        facets_of_node[all_facets[f].nodes[i]].push_back(f);
    find_edges();
    check_orientation();
    find_interior_nodes();
    find_bounds();
  }

  void ContactSurface::set_positions(const std::vector<Point<3>> &positions)
  {
    AssertThrow(positions.size() == x.size(),
                ExcMessage("A contact surface of " + std::to_string(x.size()) +
                           " nodes was given " +
                           std::to_string(positions.size()) + " positions."));
    x = positions;
    find_bounds();
  }

  void ContactSurface::find_bounds()
  {
    bounds.clear();
    for (unsigned int f = 0; f < n_facets(); ++f)
      bounds.emplace_back(facet_positions(f));
  }

  FacetPositions ContactSurface::facet_positions(const unsigned int f) const
  {
    FacetPositions result;
    result.n_nodes = all_facets[f].n_nodes;
    for (unsigned int i = 0; i < result.n_nodes; ++i)
      result.x[i] = x[all_facets[f].nodes[i]];
    return result;
  }

  std::array<unsigned int, 2>
  ContactSurface::edge_neighbours(const unsigned int f,
                                  const unsigned int i) const
  {
    const Facet       &facet = all_facets[f];
    const unsigned int local = local_number(facet, i);
    const unsigned int n     = facet.n_nodes;
    return {{facet.nodes[(local + 1) % n], facet.nodes[(local + n - 1) % n]}};
  }

  Tensor<1, 3> ContactSurface::node_normal(const unsigned int i) const
  {
    constexpr std::array<FacetCoordinates, 4> corner{
      {{{-1., -1.}}, {{1., -1.}}, {{1., 1.}}, {{-1., 1.}}}};
    Tensor<1, 3> sum;
    for (const unsigned int f : facets_of_node[i])
      {
        const unsigned int local   = local_number(all_facets[f], i);
        const bool         is_line = all_facets[f].n_nodes == 2;
        const auto         normal =
          facet_frame(facet_positions(f),
                      is_line ? FacetCoordinates{} : corner[local])
            .normal;
        const auto   next = edge_neighbours(f, i);
        const auto   e1   = x[next[0]] - x[i];
        const auto   e2   = x[next[1]] - x[i];
        const double angle =
          std::atan2(cross_product_3d(e1, e2).norm(), e1 * e2);
        sum += (is_line ? 1. : angle) * normal;
      }
    const double length = sum.norm();
    return length > 1e-12 ? sum / length : Tensor<1, 3>();
  }

  double
  ContactSurface::distance_bound(const std::array<unsigned int, 2> &nodes,
                                 const Point<3>                    &point) const
  {
    // Triangle inequality; the foot may lie a little off a free end.
    const Point<3> &x_0 = x[nodes[0]], &x_1 = x[nodes[1]];
    return 0.5 * ((point - x_0).norm() + (point - x_1).norm() -
                  (1. + 2. * free_end_tolerance) * (x_1 - x_0).norm());
  }

  BorderFoot ContactSurface::edge_foot(const unsigned int  number,
                                       const Point<3>     &point,
                                       const Tensor<1, 3> &n_s) const
  {
    const FacetEdge   &edge   = all_edges[number];
    const Tensor<1, 3> half   = 0.5 * (x[edge.nodes[1]] - x[edge.nodes[0]]);
    const Point<3>     middle = x[edge.nodes[0]] + half;

    BorderFoot foot;
    foot.xi        = (point - middle) * half / half.norm_square();
    foot.d         = point - (middle + foot.xi * half);
    const bool rim = !interior[edge.nodes[foot.xi > 0. ? 1 : 0]];
    foot.is_nearest =
      std::abs(foot.xi) <= 1. + (rim ? free_end_tolerance : inside_tolerance);
    for (const unsigned int f : edge.facets)
      {
        unsigned int e = 0;
        while (edges_of_facet[f][e] != number)
          ++e;
        const bool forward = all_facets[f].nodes[e] == edge.nodes[0];
        const auto frame =
          facet_frame(facet_positions(f),
                      on_edge(e, forward ? foot.xi : -foot.xi));
        // As d is normal to the edge, the component along it does not matter.
        const auto inward =
          (e == 0 || e == 3 ? 1. : -1.) * frame.a[e % 2 == 0 ? 1 : 0];
        foot.is_nearest = foot.is_nearest && !leads_inside(foot.d, inward);
        foot.smallest_cosine =
          std::min(foot.smallest_cosine, n_s * frame.normal);
        foot.mean_normal += frame.normal;
      }
    const double length = foot.mean_normal.norm();
    foot.mean_normal =
      length > 1e-12 ? foot.mean_normal / length : Tensor<1, 3>();
    return foot;
  }

  BorderFoot ContactSurface::vertex_foot(const unsigned int  node,
                                         const Point<3>     &point,
                                         const Tensor<1, 3> &n_s) const
  {
    BorderFoot foot;
    foot.d = point - x[node];
    for (const unsigned int f : facets_of_node[node])
      {
        for (const unsigned int i : edge_neighbours(f, node))
          foot.is_nearest =
            foot.is_nearest && !leads_inside(foot.d, x[i] - x[node]);
        const auto normal    = facet_frame(facet_positions(f), {}).normal;
        foot.smallest_cosine = std::min(foot.smallest_cosine, n_s * normal);
      }
    foot.mean_normal = node_normal(node);
    return foot;
  }

  void ContactSurface::check_facets() const
  {
    for (unsigned int f = 0; f < n_facets(); ++f)
      {
        const Facet &facet = all_facets[f];
        AssertThrow((facet.n_nodes == 2 || facet.n_nodes == 4) &&
                      facet.n_nodes == all_facets[0].n_nodes,
                    ExcMessage("Facet " + std::to_string(f) + " has " +
                               std::to_string(facet.n_nodes) +
                               " nodes; all facets of a contact surface must "
                               "have 2 or all must have 4."));
        for (unsigned int i = 0; i < facet.n_nodes; ++i)
          AssertThrow(facet.nodes[i] < x.size() &&
                        local_number(facet, facet.nodes[i]) == i,
                      ExcMessage("Facet " + std::to_string(f) + " names node " +
                                 std::to_string(facet.nodes[i]) +
                                 " twice, or beyond the " +
                                 std::to_string(x.size()) + " nodes."));
      }
  }

  void ContactSurface::find_edges()
  {
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> known;
    edges_of_facet.resize(n_facets());
    for (unsigned int f = 0; f < n_facets(); ++f)
      for (unsigned int e = 0; e < all_facets[f].n_nodes; ++e)
        {
          const auto nodes = edge_nodes(all_facets[f], e);
          const auto found =
            known.insert({std::minmax(nodes[0], nodes[1]), all_edges.size()});
          if (found.second)
            all_edges.push_back({nodes, {}});
          edges_of_facet[f][e] = found.first->second;
          all_edges[found.first->second].facets.push_back(f);
        }
  }

  void ContactSurface::check_orientation() const
  {
    for (const FacetEdge &edge : all_edges)
      {
        if (edge.facets.size() != 2)
          continue;
        const auto starts_here = [&](const unsigned int f) {
          const Facet       &facet = all_facets[f];
          const unsigned int local = local_number(facet, edge.nodes[0]);
          return facet.n_nodes == 2 ?
                   local == 0 :
                   facet.nodes[(local + 1) % 4] == edge.nodes[1];
        };
        AssertThrow(starts_here(edge.facets[0]) != starts_here(edge.facets[1]),
                    ExcMessage("The neighbouring facets " +
                               std::to_string(edge.facets[0]) + " and " +
                               std::to_string(edge.facets[1]) +
                               " have normals to opposite sides; reverse the "
                               "nodes of one of them."));
      }
  }

  void ContactSurface::find_interior_nodes()
  {
    interior.resize(x.size());
    for (unsigned int i = 0; i < x.size(); ++i)
      interior[i] = !facets_of_node[i].empty();
    for (const FacetEdge &edge : all_edges)
      if (!edge.is_shared())
        for (const unsigned int i : edge.nodes)
          interior[i] = false;
  }
} // namespace demold

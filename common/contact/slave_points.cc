// SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes of the slave surface, one point per smooth patch they belong to.
#include "contact/slave_points.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr double smooth_cosine = 0.766; // 40 degrees

    Tensor<1, 3> centre_normal(const ContactSurface &surface,
                               const unsigned int    facet)
    {
      return surface.bound(facet).normal;
    }

    /// Number of the patch of each facet.
    std::vector<unsigned int> find_patches(const ContactSurface &surface)
    {
      std::vector<unsigned int> patch(surface.n_facets());
      std::iota(patch.begin(), patch.end(), 0u);
      const auto root = [&](unsigned int f) {
        while (patch[f] != f)
          f = patch[f] = patch[patch[f]];
        return f;
      };
      for (const FacetEdge &edge : surface.edges())
        for (std::size_t k = 1; k < edge.facets.size(); ++k)
          if (centre_normal(surface, edge.facets[0]) *
                centre_normal(surface, edge.facets[k]) >
              smooth_cosine)
            patch[std::max(root(edge.facets[0]), root(edge.facets[k]))] =
              std::min(root(edge.facets[0]), root(edge.facets[k]));
      for (unsigned int f = 0; f < patch.size(); ++f)
        patch[f] = root(f);
      return patch;
    }

    /// Integral of each shape function over a facet, 2 x 2 Gauss points.
    std::array<double, 4> nodal_areas(const FacetPositions &facet,
                                      const PlaneModel &    plane)
    {
      std::array<double, 4> areas{};
      const double          g  = 1. / std::sqrt(3.);
      const bool            line = facet.n_nodes == 2;
      for (const double xi : {-g, g})
        for (const double eta : {-g, g})
          {
            const auto frame = facet_frame(facet, {{xi, line ? 0. : eta}});
            double     da =
              cross_product_3d(frame.a[0], frame.a[1]).norm();
            if (line) // half: eta is only repeated
              da *= .5 * plane_weight<2>(plane,
                                         Point<2>(frame.x[0], frame.x[1]));
            for (unsigned int i = 0; i < facet.n_nodes; ++i)
              areas[i] += frame.shape.N[i] * da;
          }
      return areas;
    }
  } // namespace

  std::vector<SlavePoint> collect_slave_points(const BoundarySurface &surface,
                                               const ContactSurface & topology,
                                               const PlaneModel &     plane)
  {
    const std::vector<unsigned int> patch = find_patches(topology);
    std::map<std::pair<unsigned int, unsigned int>, SlavePoint> points;
    for (unsigned int f = 0; f < topology.n_facets(); ++f)
      {
        const auto areas = nodal_areas(topology.facet_positions(f), plane);
        for (unsigned int i = 0; i < topology.facet(f).n_nodes; ++i)
          {
            const unsigned int node = topology.facet(f).nodes[i];
            auto &             point =
              points
                .insert({{node, patch[f]},
                         {node, {}, 0., .5 * surface.height[f]}})
                .first->second;
            point.facets.push_back(f);
            point.area += areas[i];
            point.depth = std::min(point.depth, .5 * surface.height[f]);
          }
      }
    std::vector<SlavePoint> list;
    for (const auto &entry : points)
      list.push_back(entry.second);
    return list;
  }

  Tensor<1, 3> slave_normal(const SlavePoint &    point,
                            const ContactSurface &surface)
  {
    Tensor<1, 3> sum;
    for (const unsigned int f : point.facets)
      sum += centre_normal(surface, f);
    return sum / std::max(sum.norm(), 1e-300);
  }
} // namespace demold

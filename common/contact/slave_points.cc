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

    /// Quadratic shape functions at nodes -1, 0, 1.
    std::array<double, 3> quadratic_shape(const double xi)
    {
      return {{.5 * xi * (xi - 1.), 1. - xi * xi, .5 * xi * (xi + 1.)}};
    }

    /// Integral of each shape function over a face of an element, times the
    /// plane model's length. The face is a line or bilinear facet between
    /// @p corners; with @p quadratic the functions are those of its 3^(dim-1)
    /// nodes line by line, otherwise of its corners. 2 x 2 Gauss points are
    /// exact for both, as long as the face is flat.
    std::array<double, 9> face_integrals(const FacetPositions &corners,
                                         const PlaneModel     &plane,
                                         const bool            quadratic)
    {
      std::array<double, 9> areas{};
      const double          g    = 1. / std::sqrt(3.);
      const bool            line = corners.n_nodes == 2;
      for (const double xi : {-g, g})
        for (const double eta : {-g, g})
          {
            const auto frame = facet_frame(corners, {{xi, line ? 0. : eta}});
            double     da    = cross_product_3d(frame.a[0], frame.a[1]).norm();
            if (line) // half: eta is only repeated
              da *=
                .5 * plane_weight<2>(plane, Point<2>(frame.x[0], frame.x[1]));
            if (!quadratic)
              {
                for (unsigned int i = 0; i < corners.n_nodes; ++i)
                  areas[i] += frame.shape.N[i] * da;
                continue;
              }
            const auto along  = quadratic_shape(xi),
                       across = quadratic_shape(eta);
            for (unsigned int i = 0; i < (line ? 3 : 9); ++i)
              areas[i] += along[i % 3] * (line ? 1. : across[i / 3]) * da;
          }
      return areas;
    }

    using CornerAreas = std::array<double, 4>;

    /// Gives the integrals of a quadratic face to its facets, from
    /// @p first_facet on: facets that share a node share its area equally.
    void split_quadratic_face(const std::vector<unsigned int> &nodes,
                              const ContactSurface            &topology,
                              const PlaneModel                &plane,
                              const unsigned int               first_facet,
                              std::vector<CornerAreas>        &areas)
    {
      const bool     line = nodes.size() == 3;
      FacetPositions corners;
      corners.n_nodes = line ? 2 : 4;
      const std::array<unsigned int, 4> places =
        line ? std::array<unsigned int, 4>{{0, 2, 0, 0}} :
               std::array<unsigned int, 4>{{0, 2, 8, 6}};
      for (unsigned int i = 0; i < corners.n_nodes; ++i)
        corners.x[i] = topology.positions()[nodes[places[i]]];
      const auto integrals = face_integrals(corners, plane, true);

      const unsigned int n_facets = line ? 2 : 4;
      for (unsigned int k = 0; k < nodes.size(); ++k)
        {
          std::vector<double *> shares;
          for (unsigned int f = first_facet; f < first_facet + n_facets; ++f)
            for (unsigned int i = 0; i < corners.n_nodes; ++i)
              if (topology.facet(f).nodes[i] == nodes[k])
                shares.push_back(&areas[f][i]);
          for (double *share : shares)
            *share = integrals[k] / shares.size();
        }
    }

    /// Area [mm^2] of each corner of each facet.
    std::vector<CornerAreas> corner_areas(const BoundarySurface &surface,
                                          const ContactSurface  &topology,
                                          const PlaneModel      &plane)
    {
      std::vector<CornerAreas> areas(topology.n_facets());
      unsigned int             first_facet = 0;
      for (const auto &nodes : surface.quadratic_faces)
        {
          split_quadratic_face(nodes, topology, plane, first_facet, areas);
          first_facet += nodes.size() == 3 ? 2 : 4;
        }
      for (unsigned int f = first_facet; f < topology.n_facets(); ++f)
        {
          const auto integrals =
            face_integrals(topology.facet_positions(f), plane, false);
          std::copy_n(integrals.begin(), 4, areas[f].begin());
        }
      return areas;
    }
  } // namespace

  std::vector<SlavePoint> collect_slave_points(const BoundarySurface &surface,
                                               const ContactSurface  &topology,
                                               const PlaneModel      &plane)
  {
    const std::vector<unsigned int> patch = find_patches(topology);
    const auto areas = corner_areas(surface, topology, plane);
    std::map<std::pair<unsigned int, unsigned int>, SlavePoint> points;
    for (unsigned int f = 0; f < topology.n_facets(); ++f)
      for (unsigned int i = 0; i < topology.facet(f).n_nodes; ++i)
        {
          const unsigned int node  = topology.facet(f).nodes[i];
          auto              &point = points
                          .insert({{node, patch[f]},
                                   {node, {}, 0., .5 * surface.height[f]}})
                          .first->second;
          point.facets.push_back(f);
          point.area += areas[f][i];
          point.depth = std::min(point.depth, .5 * surface.height[f]);
        }
    std::vector<SlavePoint> list;
    for (const auto &entry : points)
      list.push_back(entry.second);
    return list;
  }

  Tensor<1, 3> slave_normal(const SlavePoint     &point,
                            const ContactSurface &surface)
  {
    Tensor<1, 3> sum;
    for (const unsigned int f : point.facets)
      sum += centre_normal(surface, f);
    return sum / std::max(sum.norm(), 1e-300);
  }
} // namespace demold

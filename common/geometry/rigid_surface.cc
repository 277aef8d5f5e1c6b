// SPDX-License-Identifier: LGPL-2.1-or-later
// Normals, areas and union of rigid surfaces.
#include "geometry/rigid_surface.h"

#include <algorithm>

namespace demold
{
  using namespace dealii;

  namespace
  {
    // Normal whose length is the area of the facet: half the cross product
    // of the diagonals, exact for plane quadrilaterals.
    Tensor<1, 3> area_vector(const RigidSurface &surface,
                             const unsigned int  facet)
    {
      const auto &f = surface.facets[facet];
      const auto  x = [&](const unsigned int i) {
        return surface.vertices[f.v[i]];
      };
      if (f.n == 2)
        {
          const Tensor<1, 3> t = x(1) - x(0);
          Tensor<1, 3>       n;
          n[0] = t[1];
          n[1] = -t[0];
          return n;
        }
      return 0.5 * cross_product_3d(x(2) - x(0), x(3) - x(1));
    }
  } // namespace

  Tensor<1, 3> facet_normal(const RigidSurface &surface,
                            const unsigned int  facet)
  {
    const Tensor<1, 3> n = area_vector(surface, facet);
    return n / n.norm();
  }

  double facet_area(const RigidSurface &surface, const unsigned int facet)
  {
    return area_vector(surface, facet).norm();
  }

  Point<3> facet_centre(const RigidSurface &surface, const unsigned int facet)
  {
    const auto &f = surface.facets[facet];
    Point<3>    centre;
    for (unsigned int i = 0; i < f.n; ++i)
      centre += surface.vertices[f.v[i]] / f.n;
    return centre;
  }

  double surface_area(const RigidSurface &surface)
  {
    double area = 0;
    for (unsigned int f = 0; f < surface.facets.size(); ++f)
      area += facet_area(surface, f);
    return area;
  }

  void append_surface(RigidSurface &surface, const RigidSurface &other)
  {
    const unsigned int n_vertices = surface.vertices.size();
    const unsigned int n_patches =
      surface.patch.empty() ?
        0 :
        *std::max_element(surface.patch.begin(), surface.patch.end()) + 1;

    surface.vertices.insert(surface.vertices.end(),
                            other.vertices.begin(),
                            other.vertices.end());
    for (RigidSurface::Facet facet : other.facets)
      {
        for (unsigned int i = 0; i < facet.n; ++i)
          facet.v[i] += n_vertices;
        surface.facets.push_back(facet);
      }
    for (const unsigned int patch : other.patch)
      surface.patch.push_back(n_patches + patch);
  }
} // namespace demold

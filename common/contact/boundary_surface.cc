// SPDX-License-Identifier: LGPL-2.1-or-later
// The faces of the rubber that may touch: nodes, unknowns, facets.
#include "contact/boundary_surface.h"

#include "base/plane_model.h"

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <map>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Nodes of one face on a lattice of (degree + 1)^(dim - 1) points.
    struct FaceLattice
    {
      unsigned int              n; ///< points per direction
      std::vector<unsigned int> nodes;
    };

    class SurfaceBuilder
    {
    public:
      template <int dim>
      FaceLattice
      add_face(const typename DoFHandler<dim, dim>::active_cell_iterator &cell,
               const unsigned int                                         face)
      {
        const auto                          &fe = cell->get_fe();
        std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
        cell->get_dof_indices(indices);

        // lattice position of each support point of the face, from its unit
        // coordinates along the two directions in the face
        const unsigned int normal_direction = face / 2;
        FaceLattice        lattice{fe.degree + 1, {}};
        lattice.nodes.resize(dim == 2 ? lattice.n : lattice.n * lattice.n);
        for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
          {
            if (!fe.has_support_on_face(i, face))
              continue;
            const auto         unit = fe.unit_support_point(i);
            const unsigned int component =
              fe.system_to_component_index(i).first;
            unsigned int place = 0, stride = 1;
            for (unsigned int d = 0; d < dim; ++d)
              if (d != normal_direction)
                {
                  place += stride *
                           static_cast<unsigned int>(unit[d] * fe.degree + .5);
                  stride *= lattice.n;
                }
            if (component == 0)
              lattice.nodes[place] =
                node_of(indices[i],
                        in_space(StaticMappingQ1<dim>::mapping
                                   .transform_unit_to_real_cell(cell, unit)));
          }
        for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
          if (fe.has_support_on_face(i, face))
            {
              const auto component = fe.system_to_component_index(i);
              const auto first     = fe.component_to_system_index(
                0,
                component.second); // same support point
              surface.nodes[number.at(indices[first])]
                .unknowns[component.first] = indices[i];
            }
        return lattice;
      }

      BoundarySurface surface;

    private:
      unsigned int node_of(const types::global_dof_index first_unknown,
                           const dealii::Point<3>       &X)
      {
        const auto found = number.find(first_unknown);
        if (found != number.end())
          return found->second;
        surface.nodes.push_back(
          {X, {{first_unknown, first_unknown, first_unknown}}});
        return number[first_unknown] = surface.nodes.size() - 1;
      }

      std::map<types::global_dof_index, unsigned int> number;
    };

    /// Turns a facet around if its normal points to @p inside.
    void orient(Facet                                    &facet,
                const std::vector<BoundarySurface::Node> &nodes,
                const dealii::Point<3>                   &inside)
    {
      FacetPositions positions;
      positions.n_nodes = facet.n_nodes;
      for (unsigned int i = 0; i < facet.n_nodes; ++i)
        positions.x[i] = nodes[facet.nodes[i]].X;
      const auto frame = facet_frame(positions, {{0., 0.}});
      if (frame.normal * (frame.x - inside) < 0.)
        {
          if (facet.n_nodes == 2)
            std::swap(facet.nodes[0], facet.nodes[1]);
          else
            std::swap(facet.nodes[1], facet.nodes[3]);
        }
    }
  } // namespace

  std::vector<dealii::Point<3>> BoundarySurface::positions() const
  {
    std::vector<dealii::Point<3>> x;
    for (const Node &node : nodes)
      x.push_back(node.X);
    return x;
  }

  template <int dim>
  BoundarySurface
  extract_surface(const DoFHandler<dim, dim>         &dof_handler,
                  const std::set<types::boundary_id> &boundary_ids)
  {
    SurfaceBuilder builder;
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          if (!cell->face(f)->at_boundary() ||
              boundary_ids.count(cell->face(f)->boundary_id()) == 0)
            continue;
          const FaceLattice lattice = builder.add_face<dim>(cell, f);
          const double      height =
            cell->measure() / cell->face(f)->measure() / (lattice.n - 1);
          if (lattice.n == 3)
            builder.surface.quadratic_faces.push_back(lattice.nodes);
          for (unsigned int j = 0; j < (dim == 2 ? 1 : lattice.n - 1); ++j)
            for (unsigned int i = 0; i + 1 < lattice.n; ++i)
              {
                const auto at = [&](const unsigned int a,
                                    const unsigned int b) {
                  return lattice.nodes[a + b * lattice.n];
                };
                Facet facet;
                if (dim == 2)
                  facet = {{{at(i, 0), at(i + 1, 0), 0, 0}}, 2};
                else
                  facet = {
                    {{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}},
                    4};
                orient(facet, builder.surface.nodes, in_space(cell->center()));
                builder.surface.facets.push_back(facet);
                builder.surface.height.push_back(height);
              }
        }
    return builder.surface;
  }

  template BoundarySurface
  extract_surface<2>(const DoFHandler<2, 2> &,
                     const std::set<types::boundary_id> &);
  template BoundarySurface
  extract_surface<3>(const DoFHandler<3, 3> &,
                     const std::set<types::boundary_id> &);
} // namespace demold

// SPDX-License-Identifier: LGPL-2.1-or-later
// Slave faces with their multiplier points, and the master facets near them.
#include "mortar/mortar_surfaces.h"

#include "contact/current_positions.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <numeric>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Facets whose normals enclose less than 120 degrees do not pair.
    constexpr double opposing_cosine = -.5;
  } // namespace

  MortarSurfaces::MortarSurfaces(BoundarySurface             slave,
                                 Master                      master,
                                 const InterfaceDescription &description,
                                 const IndexSet             &owned,
                                 MPI_Comm                    communicator)
    : communicator(communicator)
    , search_distance(description.search_distance)
    , slave_nodes(std::move(slave))
    , slave_surface(slave_nodes.facets, slave_nodes.positions())
    , other_side(std::move(master))
    , all_points(
        collect_slave_points(slave_nodes, slave_surface, description.plane))
    , search(largest_reach(), description.skin)
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    owner.assign(all_points.size(), 0);
    for (unsigned int p = 0; p < all_points.size(); ++p)
      if (owned.is_element(slave_nodes.nodes[all_points[p].node].unknowns[0]))
        {
          mine.push_back(p);
          owner[p] = rank;
        }
    const std::vector<unsigned int> of_this_rank = owner;
    Utilities::MPI::max(of_this_rank, communicator, owner);
    number_points();
    search.rebuild(other_side.surface, face_centres());
  }

  void MortarSurfaces::number_points()
  {
    points_of_face.resize(slave_surface.n_facets());
    for (unsigned int p = 0; p < all_points.size(); ++p)
      for (const unsigned int f : all_points[p].facets)
        for (unsigned int i = 0; i < slave_surface.facet(f).n_nodes; ++i)
          if (slave_surface.facet(f).nodes[i] == all_points[p].node)
            points_of_face[f][i] = p;
  }

  std::vector<Point<3>> MortarSurfaces::face_centres() const
  {
    std::vector<Point<3>> centres;
    for (unsigned int f = 0; f < slave_surface.n_facets(); ++f)
      centres.push_back(slave_surface.bound(f).centre);
    return centres;
  }

  /// From the centre of a face: its own radius, and what may be opposite. A
  /// stretched face still fits by half its radius; the skin covers the rest.
  double MortarSurfaces::largest_reach() const
  {
    double reach = 0.;
    for (unsigned int f = 0; f < slave_surface.n_facets(); ++f)
      reach = std::max(reach,
                       1.5 * slave_surface.bound(f).radius +
                         std::max(search_distance, .5 * slave_nodes.height[f]));
    return reach;
  }

  double MortarSurfaces::mean_height() const
  {
    return std::accumulate(slave_nodes.height.begin(),
                           slave_nodes.height.end(),
                           0.) /
           std::max<std::size_t>(slave_nodes.height.size(), 1);
  }

  void MortarSurfaces::move_to(const Configuration &state)
  {
    if (other_side.is_rigid())
      other_side.move_to(state.time);
    else
      other_side.surface.set_positions(
        current_positions(other_side.nodes, state.u, dim()));
    slave_surface.set_positions(
      current_positions(slave_nodes.nodes, state.u, dim()));

    const auto centres = face_centres();
    search_was_rebuilt =
      Utilities::MPI::max(search.is_outdated(other_side.surface, centres) ? 1 :
                                                                            0,
                          communicator) == 1;
    if (search_was_rebuilt)
      search.rebuild(other_side.surface, centres);
  }

  std::vector<unsigned int>
  MortarSurfaces::opposite(const unsigned int face) const
  {
    const FacetBound         &own = slave_surface.bound(face);
    std::vector<unsigned int> facets;
    for (const unsigned int f : search.candidates(face))
      {
        const FacetBound &other = other_side.surface.bound(f);
        if (other.normal * own.normal > opposing_cosine ||
            (other.centre - own.centre).norm() >
              other.radius + own.radius +
                std::max(depth(face), search_distance))
          continue;
        const FacetPositions facet  = other_side.surface.facet_positions(f);
        double               lowest = 1e300, highest = -1e300;
        for (unsigned int i = 0; i < facet.n_nodes; ++i)
          {
            const double h = (facet.x[i] - own.centre) * own.normal;
            lowest         = std::min(lowest, h);
            highest        = std::max(highest, h);
          }
        if (lowest <= search_distance && highest >= -depth(face))
          facets.push_back(f);
      }
    return facets;
  }

  void MortarSurfaces::add_nodes_around(const unsigned int      face,
                                        std::set<unsigned int> &nodes) const
  {
    add_slave_nodes(face, nodes);
    for (const unsigned int f : search.candidates(face))
      add_master_nodes(f, nodes);
  }

  void MortarSurfaces::add_slave_nodes(const unsigned int      face,
                                       std::set<unsigned int> &nodes) const
  {
    const Facet &facet = slave_surface.facet(face);
    nodes.insert(facet.nodes.begin(), facet.nodes.begin() + facet.n_nodes);
  }

  void MortarSurfaces::add_master_nodes(const unsigned int      facet,
                                        std::set<unsigned int> &nodes) const
  {
    const Facet &other = other_side.surface.facet(facet);
    for (unsigned int i = 0; i < other.n_nodes; ++i)
      nodes.insert(n_slave_nodes() + other.nodes[i]);
  }

  IndexSet
  MortarSurfaces::all_unknowns(const types::global_dof_index size) const
  {
    IndexSet set(size);
    for (const auto *nodes : {&slave_nodes.nodes, &other_side.nodes})
      for (const BoundarySurface::Node &node : *nodes)
        for (unsigned int d = 0; d < dim(); ++d)
          set.add_index(node.unknowns[d]);
    return set;
  }
} // namespace demold

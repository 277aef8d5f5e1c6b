// SPDX-License-Identifier: LGPL-2.1-or-later
// Slave points and master where they are now, and which point meets what.
#include "contact/surface_pair.h"

#include "contact/current_positions.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <set>

namespace demold
{
  using namespace dealii;

  namespace
  {
    std::vector<SlavePoint> points_of_rank(const BoundarySurface &slave,
                                           const ContactSurface  &topology,
                                           const PlaneModel      &plane,
                                           const IndexSet        &owned)
    {
      std::vector<SlavePoint> points;
      for (const SlavePoint &point :
           collect_slave_points(slave, topology, plane))
        if (owned.is_element(slave.nodes[point.node].unknowns[0]))
          points.push_back(point);
      return points;
    }

    /// Largest penetration [mm] that any of the points believes.
    double deepest(const std::vector<SlavePoint> &points)
    {
      double depth = 0.;
      for (const SlavePoint &point : points)
        depth = std::max(depth, point.depth);
      return depth;
    }
  } // namespace

  SurfacePair::SurfacePair(BoundarySurface             slave_,
                           Master                      master,
                           const InterfaceDescription &description,
                           const IndexSet             &owned)
    : slave(std::move(slave_))
    , slave_surface(slave.facets, slave.positions())
    , other_side(std::move(master))
    , points(points_of_rank(slave, slave_surface, description.plane, owned))
    , search_distance(description.search_distance)
    , search(std::max(search_distance, deepest(points)), description.skin)
  {
    for (const SlavePoint &point : points)
      x_points.push_back(slave.nodes[point.node].X);
    pairings.resize(points.size());
    search.rebuild(other_side.surface, x_points);
  }

  void SurfacePair::move_to(const Configuration &state, MPI_Comm communicator)
  {
    if (other_side.is_rigid())
      other_side.move_to(state.time);
    else
      other_side.surface.set_positions(
        current_positions(other_side.nodes, state.u, dim()));
    const std::vector<Point<3>> x_slave =
      current_positions(slave.nodes, state.u, dim());
    slave_surface.set_positions(x_slave);
    for (unsigned int p = 0; p < points.size(); ++p)
      x_points[p] = x_slave[points[p].node];

    search_was_rebuilt =
      Utilities::MPI::max(search.is_outdated(other_side.surface, x_points) ? 1 :
                                                                             0,
                          communicator) == 1;
    if (search_was_rebuilt)
      search.rebuild(other_side.surface, x_points);
    if (state.iteration == 0)
      std::fill(pairings.begin(), pairings.end(), std::nullopt);
  }

  std::optional<ContactPoint>
  SurfacePair::nearest(const unsigned int p,
                       const unsigned int last_facet) const
  {
    return find_contact(x_points[p],
                        slave_normal(points[p], slave_surface),
                        other_side.surface,
                        search.candidates(p),
                        last_facet,
                        {search_distance, points[p].depth});
  }

  SurfacePair::BondFoot SurfacePair::bond_foot(const unsigned int  p,
                                               const ContactPoint &found) const
  {
    if (found.kind == ContactCase::face)
      return {found.facet, found.xi};
    const ContactSurface            &surface = other_side.surface;
    const std::vector<unsigned int> &around =
      found.kind == ContactCase::edge ? surface.edges()[found.edge].facets :
                                        surface.facets_at_node(found.nodes[0]);
    const Tensor<1, 3> n = slave_normal(points[p], slave_surface);
    const unsigned int facet =
      *std::min_element(around.begin(),
                        around.end(),
                        [&](const unsigned int f, const unsigned int g) {
                          return surface.bound(f).normal * n <
                                 surface.bound(g).normal * n;
                        });
    FacetCoordinates xi =
      project(x_points[p], surface.facet_positions(facet)).xi;
    for (double &coordinate : xi)
      coordinate = std::max(-1., std::min(1., coordinate));
    return {facet, xi};
  }

  const std::optional<ContactPoint> &
  SurfacePair::pair(const Configuration  &state,
                    const unsigned int    p,
                    const ContactHistory &old)
  {
    std::optional<ContactPoint> found;
    if (NewtonStage{state.iteration}.keeps_pairings() && pairings[p])
      found = project_again(*pairings[p], x_points[p], other_side.surface);
    if (!found)
      found = nearest(p, old.last_facet);
    if (found && !may_close(state, p, old, *found))
      found.reset();
    pairings[p] = found;
    return pairings[p];
  }

  bool SurfacePair::may_close(const Configuration  &state,
                              const unsigned int    p,
                              const ContactHistory &old,
                              const ContactPoint   &found) const
  {
    const auto &surface = other_side.surface;
    if (found.gap > touching_gap || !other_side.is_rigid())
      return true;
    if (old.closed && surface.bound(old.last_facet).normal *
                          surface.bound(found.facet).normal >
                        smooth_cosine)
      return true;
    if (old.closed && found.kind != ContactCase::face)
      {
        // Concave, as the point is behind it: an edge or corner of the facet
        // that held the point leaves no way through.
        const auto &held  = surface.facet(old.last_facet).nodes;
        const auto &nodes = found.nodes;
        if (std::all_of(nodes.begin(),
                        nodes.begin() + found.n_nodes,
                        [&held](const unsigned int i) {
                          return std::count(held.begin(), held.end(), i) > 0;
                        }))
          return true;
      }
    const Point<3> x_old =
      other_side.carried(state.time - state.dt,
                         current_position(node(p), state.u_old, dim()));
    const Tensor<1, 3> &n       = found.mean_normal;
    const double        old_gap = found.gap + n * (x_old - x_points[p]);
    return old_gap > -.01 * points[p].depth;
  }

  NodalUnknowns SurfacePair::unknowns(const unsigned int p) const
  {
    NodalUnknowns result;
    result.add(node(p), 0, dim());
    return result;
  }

  void
  SurfacePair::add_master_unknowns(const std::array<unsigned int, 4> &nodes,
                                   const unsigned int                 n,
                                   const unsigned int                 first,
                                   NodalUnknowns &unknowns) const
  {
    if (other_side.is_rigid())
      return;
    for (unsigned int i = 0; i < n; ++i)
      unknowns.add(other_side.nodes[nodes[i]], first + i, dim());
  }

  NodalUnknowns SurfacePair::couplings(const unsigned int        p,
                                       std::vector<unsigned int> facets) const
  {
    NodalUnknowns result = unknowns(p);
    if (other_side.is_rigid())
      return result;
    for (const unsigned int f : search.candidates(p))
      facets.push_back(f);
    if (pairings[p]) // frozen, it may have left the candidates
      facets.push_back(pairings[p]->facet);
    std::set<unsigned int> nodes;
    for (const unsigned int f : facets)
      for (unsigned int i = 0; i < other_side.surface.facet(f).n_nodes; ++i)
        nodes.insert(other_side.surface.facet(f).nodes[i]);
    for (const unsigned int i : nodes)
      result.add(other_side.nodes[i], 0, dim());
    return result;
  }

  IndexSet SurfacePair::all_unknowns(const types::global_dof_index size) const
  {
    IndexSet set(size);
    for (const auto *nodes : {&slave.nodes, &other_side.nodes})
      for (const BoundarySurface::Node &node : *nodes)
        for (const auto i : node.unknowns)
          set.add_index(i);
    return set;
  }
} // namespace demold

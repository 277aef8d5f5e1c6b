// SPDX-License-Identifier: LGPL-2.1-or-later
// A surface of facets: current node positions and who neighbours whom.
#ifndef demold_contact_contact_surface_h
#define demold_contact_contact_surface_h

#include "contact/facet.h"
#include "contact/facet_bound.h"

#include <array>
#include <vector>

namespace demold
{
  /// An edge of facets, with all facets that meet there. In 2-D the edges are
  /// the end points of the lines, and both entries of nodes are equal.
  struct FacetEdge
  {
    std::array<unsigned int, 2> nodes;
    std::vector<unsigned int>   facets; ///< ascending; one: a free end

    bool is_shared() const
    {
      return facets.size() > 1;
    }
  };

  /// A foot may lie this far (in xi) beyond a free end of the surface...
  constexpr double free_end_tolerance = 0.02;

  /// ...and this far beyond a border shared with another facet.
  constexpr double inside_tolerance = 1e-10;

  /// Closest point on an edge or vertex, seen from a point in space.
  struct BorderFoot
  {
    double               xi = 0.; ///< on an edge, -1 at nodes[0], 1 at nodes[1]
    dealii::Tensor<1, 3> d;       ///< [mm] from the foot to the point
    bool   is_nearest      = true; ///< of the edge and all facets around it?
    double smallest_cosine = 1.;   ///< of n_s and the normals of these facets
    dealii::Tensor<1, 3> mean_normal; ///< unit length, or 0 if they cancel

    /// [mm] distance, negative on the side the mean normal points away from.
    double gap() const
    {
      return d * mean_normal < 0. ? -d.norm() : d.norm();
    }
  };

  /// Facets over nodes whose positions move. The topology is fixed at
  /// construction: nodes are shared by number, so coincident nodes must have
  /// been merged before. All facets have the same number of nodes.
  class ContactSurface
  {
  public:
    /// @p positions [mm], one per node. Throws dealii::ExcMessage if facets
    /// of 2 and 4 nodes are mixed, if a node number is out of range, or if
    /// two neighbours are oriented against each other.
    ContactSurface(std::vector<Facet>            facets,
                   std::vector<dealii::Point<3>> positions);

    /// Takes over new positions [mm] of all nodes.
    void set_positions(const std::vector<dealii::Point<3>> &positions);

    unsigned int n_facets() const
    {
      return all_facets.size();
    }

    unsigned int n_nodes() const
    {
      return x.size();
    }

    /// 2 for lines, 3 for faces.
    unsigned int n_dimensions() const
    {
      return n_facets() > 0 && all_facets[0].n_nodes == 2 ? 2 : 3;
    }

    const Facet &facet(const unsigned int f) const
    {
      return all_facets[f];
    }

    const std::vector<dealii::Point<3>> &positions() const
    {
      return x;
    }

    /// Current positions [mm] of the nodes of facet @p f.
    FacetPositions facet_positions(const unsigned int f) const;

    /// Ball and mean normal of facet @p f now.
    const FacetBound &bound(const unsigned int f) const
    {
      return bounds[f];
    }

    const std::vector<FacetEdge> &edges() const
    {
      return all_edges;
    }

    /// Number of edge @p e of facet @p f. 3-D: edge e runs from node e to
    /// node e + 1 of the facet, e < 4; 2-D: edge e is node e, e < 2.
    unsigned int facet_edge(const unsigned int f, const unsigned int e) const
    {
      return edges_of_facet[f][e];
    }

    /// Facets around a node, ascending.
    const std::vector<unsigned int> &facets_at_node(const unsigned int i) const
    {
      return facets_of_node[i];
    }

    /// Is the node surrounded by facets, with no free end passing through?
    bool is_interior(const unsigned int i) const
    {
      return interior[i];
    }

    /// The nodes that edges of facet @p f connect with its node @p i: two in
    /// 3-D; one in 2-D, given twice.
    std::array<unsigned int, 2> edge_neighbours(const unsigned int f,
                                                const unsigned int i) const;

    /// Outward unit normal at a node: normals of the facets around it,
    /// weighted with the angle each spans there (in 2-D equally), so that
    /// its sign separates inside from outside at any kind of vertex
    /// (Baerentzen and Aanaes 2005). 0 where the facets cancel.
    dealii::Tensor<1, 3> node_normal(const unsigned int i) const;

    /// Cheap lower bound of the distance [mm] from @p point to the edge
    /// between two nodes, or to a node given twice.
    double distance_bound(const std::array<unsigned int, 2> &nodes,
                          const dealii::Point<3>            &point) const;

    /// Foot of @p point on the line through an edge (3-D only); @p n_s is the
    /// normal for smallest_cosine.
    BorderFoot edge_foot(const unsigned int          edge,
                         const dealii::Point<3>     &point,
                         const dealii::Tensor<1, 3> &n_s) const;

    /// The same for a node.
    BorderFoot vertex_foot(const unsigned int          node,
                           const dealii::Point<3>     &point,
                           const dealii::Tensor<1, 3> &n_s) const;

  private:
    std::vector<Facet>                       all_facets;
    std::vector<dealii::Point<3>>            x;
    std::vector<FacetEdge>                   all_edges;
    std::vector<std::array<unsigned int, 4>> edges_of_facet;
    std::vector<std::vector<unsigned int>>   facets_of_node;
    std::vector<bool>                        interior;
    std::vector<FacetBound>                  bounds;

    void find_bounds();

    void check_facets() const;
    void find_edges();
    void check_orientation() const;
    void find_interior_nodes();
  };
} // namespace demold

#endif

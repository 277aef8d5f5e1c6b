// SPDX-License-Identifier: LGPL-2.1-or-later
// Slave faces with their multiplier points, and the master facets near them.
#ifndef demold_mortar_mortar_surfaces_h
#define demold_mortar_mortar_surfaces_h

#include "contact/candidate_search.h"
#include "contact/interface_description.h"
#include "contact/master.h"
#include "contact/slave_points.h"
#include "weak_form/term.h"

#include <deal.II/base/index_set.h>

#include <mpi.h>

#include <set>
#include <vector>

namespace demold
{
  /// The two surfaces of a mortar interface. Slave and master nodes share one
  /// numbering here: slave nodes first, then master nodes.
  ///
  /// Every rank knows all points, one per node and smooth patch (theory B.11),
  /// and treats those whose node it owns.
  class MortarSurfaces
  {
  public:
    /// Both in the reference position. @p owned are the unknowns of this rank.
    MortarSurfaces(BoundarySurface             slave,
                   Master                      master,
                   const InterfaceDescription &description,
                   const dealii::IndexSet     &owned,
                   MPI_Comm                    communicator);

    /// Moves both to the trial state and renews the candidates on all ranks
    /// where needed.
    void move_to(const Configuration &state);

    /// Did the last move_to() renew the candidates?
    bool has_new_candidates() const
    {
      return search_was_rebuilt;
    }

    const std::vector<SlavePoint> &points() const
    {
      return all_points;
    }

    /// Numbers of the points of this rank, ascending.
    const std::vector<unsigned int> &own_points() const
    {
      return mine;
    }

    /// Rank that treats each point.
    const std::vector<unsigned int> &owners() const
    {
      return owner;
    }

    /// Number of the point that node @p local of face @p face belongs to.
    unsigned int point_of(const unsigned int face,
                          const unsigned int local) const
    {
      return points_of_face[face][local];
    }

    /// Master facets that may lie opposite a slave face now: within the search
    /// distance, not deeper than half the cell behind the face, with a normal
    /// that opposes it by more than 120 degrees (theory B.11).
    std::vector<unsigned int> opposite(const unsigned int face) const;

    /// [mm] deepest penetration that a face believes.
    double depth(const unsigned int face) const
    {
      return .5 * slave_nodes.height[face];
    }

    /// Adds the nodes of a slave face and of all its candidates.
    void add_nodes_around(const unsigned int      face,
                          std::set<unsigned int> &nodes) const;

    /// Adds the nodes of a slave face.
    void add_slave_nodes(const unsigned int      face,
                         std::set<unsigned int> &nodes) const;

    /// Adds the nodes of a master facet.
    void add_master_nodes(const unsigned int      facet,
                          std::set<unsigned int> &nodes) const;

    const ContactSurface &slave() const
    {
      return slave_surface;
    }

    const Master &master() const
    {
      return other_side;
    }

    /// [mm] mean height of the cells behind the slave faces.
    double mean_height() const;

    unsigned int dim() const
    {
      return slave_surface.n_dimensions();
    }

    unsigned int n_slave_nodes() const
    {
      return slave_nodes.nodes.size();
    }

    bool is_slave(const unsigned int node) const
    {
      return node < n_slave_nodes();
    }

    /// Does the node move without unknowns?
    bool is_rigid(const unsigned int node) const
    {
      return !is_slave(node) && other_side.is_rigid();
    }

    /// A node with unknowns.
    const BoundarySurface::Node &node(const unsigned int number) const
    {
      return is_slave(number) ? slave_nodes.nodes[number] :
                                other_side.nodes[number - n_slave_nodes()];
    }

    /// Current place [mm] of a node.
    const dealii::Point<3> &x(const unsigned int node) const
    {
      return is_slave(node) ?
               slave_surface.positions()[node] :
               other_side.surface.positions()[node - n_slave_nodes()];
    }

    /// Unknowns of both surfaces, of @p size altogether.
    dealii::IndexSet
    all_unknowns(const dealii::types::global_dof_index size) const;

  private:
    std::vector<dealii::Point<3>> face_centres() const;
    double                        largest_reach() const;
    void                          number_points();

    const MPI_Comm                           communicator;
    const double                             search_distance;
    BoundarySurface                          slave_nodes;
    ContactSurface                           slave_surface;
    Master                                   other_side;
    std::vector<SlavePoint>                  all_points;
    std::vector<unsigned int>                mine, owner;
    std::vector<std::array<unsigned int, 4>> points_of_face;
    CandidateSearch                          search;
    bool                                     search_was_rebuilt = false;
  };
} // namespace demold

#endif

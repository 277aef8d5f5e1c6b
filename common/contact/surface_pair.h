// SPDX-License-Identifier: LGPL-2.1-or-later
// Slave points and master where they are now, and which point meets what.
#ifndef demold_contact_surface_pair_h
#define demold_contact_surface_pair_h

#include "contact/candidate_search.h"
#include "contact/closest_point.h"
#include "contact/interface_description.h"
#include "contact/master.h"
#include "contact/newton_stage.h"
#include "contact/nodal_force.h"
#include "contact/point_history.h"
#include "contact/slave_points.h"
#include "weak_form/term.h"

#include <deal.II/base/index_set.h>

#include <mpi.h>

#include <optional>
#include <vector>

namespace demold
{


  /// The two surfaces of an interface with the slave points of this rank.
  ///
  /// A point closes by coming through the gap: a rigid facet that it already
  /// was behind at t_n, without touching its surface, is not believed. Else a
  /// node that slips off the end of a blade would find itself deep in the
  /// blade's tip, with energy from nowhere.
  class SurfacePair
  {
  public:
    /// Both in the reference position. @p owned are the unknowns of this rank.
    SurfacePair(BoundarySurface             slave,
                Master                      master,
                const InterfaceDescription &description,
                const dealii::IndexSet     &owned);

    /// Moves both to the trial state and renews the candidates on all ranks
    /// where needed. The first iteration of an increment forgets pairings.
    void move_to(const Configuration &state, MPI_Comm communicator);

    /// Did the last move_to() renew the candidates?
    bool has_new_candidates() const
    {
      return search_was_rebuilt;
    }

    unsigned int n_points() const
    {
      return points.size();
    }

    const SlavePoint &point(const unsigned int p) const
    {
      return points[p];
    }

    const BoundarySurface::Node &node(const unsigned int p) const
    {
      return slave.nodes[points[p].node];
    }

    /// Current place [mm] of a point.
    const dealii::Point<3> &x(const unsigned int p) const
    {
      return x_points[p];
    }

    const Master &master() const
    {
      return other_side;
    }

    unsigned int dim() const
    {
      return slave_surface.n_dimensions();
    }

    /// Where a bond of the point takes hold: the foot on the facet @p found
    /// lies on, or, at an edge or vertex, on the facet around it that the
    /// point faces most. Within the facet, which the foot proper need not be.
    struct BondFoot
    {
      unsigned int     facet;
      FacetCoordinates xi;
    };
    BondFoot bond_foot(const unsigned int p, const ContactPoint &found) const;

    /// What the point is nearest to, of everything within reach.
    std::optional<ContactPoint> nearest(const unsigned int p,
                                        const unsigned int last_facet) const;

    /// Pairs a point anew, or keeps its last pairing where the stage of Newton
    /// says so. Remembers and returns what it meets, if it may.
    const std::optional<ContactPoint> &pair(const Configuration  &state,
                                            const unsigned int    p,
                                            const ContactHistory &old);

    /// What pair() found last.
    const std::optional<ContactPoint> &last_pairing(const unsigned int p) const
    {
      return pairings[p];
    }

    /// Unknowns of a point alone.
    NodalUnknowns unknowns(const unsigned int p) const;

    /// Appends those of @p n nodes of the master as numbers @p first, ... in
    /// the local arrays; a rigid master has none.
    void add_master_unknowns(const std::array<unsigned int, 4> &nodes,
                             const unsigned int                 n,
                             const unsigned int                 first,
                             NodalUnknowns                     &unknowns) const;

    /// Everything a point may couple with: its own unknowns, and those of
    /// candidates, last pairing and @p more_facets.
    NodalUnknowns couplings(const unsigned int        p,
                            std::vector<unsigned int> more_facets) const;

    /// Unknowns of both surfaces, of @p size altogether.
    dealii::IndexSet
    all_unknowns(const dealii::types::global_dof_index size) const;

  private:
    bool may_close(const Configuration  &state,
                   const unsigned int    p,
                   const ContactHistory &old,
                   const ContactPoint   &found) const;

    BoundarySurface         slave;
    ContactSurface          slave_surface;
    Master                  other_side;
    std::vector<SlavePoint> points; ///< of this rank
    const double            search_distance;
    CandidateSearch         search;
    bool                    search_was_rebuilt = false;

    std::vector<dealii::Point<3>>            x_points;
    std::vector<std::optional<ContactPoint>> pairings;
  };
} // namespace demold

#endif

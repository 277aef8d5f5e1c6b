// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact, friction and adhesion between slave nodes and master facets.
#ifndef demold_contact_node_to_segment_h
#define demold_contact_node_to_segment_h

#include "adhesion/adhesion_law.h"
#include "contact/candidate_search.h"
#include "contact/contact_kinematics.h"
#include "contact/point_history.h"
#include "contact/slave_points.h"
#include "weak_form/term.h"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <functional>
#include <optional>

namespace demold
{
  /// What acts between the surfaces.
  struct InterfaceDescription
  {
    double                     penalty         = 200.; ///< c_N [MPa/mm]
    double                     search_distance = 1.;   ///< [mm]
    double                     skin            = .5;   ///< [mm]
    double                     friction         = 0.; ///< mu [-], 0: none
    double                     friction_penalty = 50.; ///< c_T [MPa/mm]
    std::optional<AdhesionLaw> adhesion;

    /// Is this reference position bonded at the start?
    std::function<bool(const dealii::Point<3> &)> bonded =
      [](const dealii::Point<3> &) { return true; };
    PlaneModel plane;
  };

  /// One slave point as others see it.
  struct PointReport
  {
    BoundarySurface::Node node;
    double                area;     ///< [mm^2]
    double                gap;      ///< [mm], 1e300: nothing near
    double                pressure; ///< [MPa], compression positive
    dealii::Tensor<1, 3>  force;    ///< [N] on the rubber
    bool                  bonded;   ///< carries a bond that is not ruptured
    double                damage;   ///< kappa over rupture gap, 0 to 1
    int                   state;    ///< theory C.5, 0 to 5; 6: free
    double                separation_time; ///< [s], -1: never
  };

  /// Sums over all slave points and ranks.
  struct InterfaceSums
  {
    dealii::Tensor<1, 3> force;         ///< [N] of the mould on the rubber
    double               area   = 0.;   ///< [mm^2] of the slave surface
    double               bonded = 0.;   ///< [mm^2] with a bond
    double               closed = 0.;   ///< [mm^2] under pressure
    unsigned int         points = 0;
  };

  /// Node-to-segment contact (thesis 3.1, 5.2): every slave point is held off
  /// the master by the penalty c_N, rubs by the moving friction cone and is
  /// tied to its anchor by the adhesion law (theory C.2, C.3). Forces are per
  /// reference area. The friction weight omega is that of the damage at the
  /// start of the increment. All tangents are exact in the first iterations,
  /// before states are frozen. With a rigid master, mixing with a = b^2 and no
  /// friction they are symmetric.
  ///
  /// A point closes by coming through the gap: a rigid facet that it already
  /// was behind at t_n, without touching its surface, is not believed. Else a
  /// node that slips off the end of a blade would find itself deep in the
  /// blade's tip, with energy from nowhere.
  class NodeToSegment : public Term
  {
  public:
    NodeToSegment(BoundarySurface             slave,
                  Master                      master,
                  const InterfaceDescription &description,
                  const dealii::IndexSet &    owned,
                  MPI_Comm                    communicator);

    std::string  name() const override;
    TermKind     kind() const override;
    bool         symmetric() const override;
    void         needed_unknowns(dealii::IndexSet &) const override;
    void         add_couplings(
              dealii::DynamicSparsityPattern &,
              const dealii::AffineConstraints<double> &) const override;
    bool         couplings_changed() const override;
    void         prepare(const Configuration &) override;
    bool         assemble(const Configuration &, Assembler &) override;
    unsigned int n_state_changes() const override;
    IncrementError           increment_error() const override;
    std::vector<ClosedPoint> closed_points() const override;
    Energies                 energies() const override;
    void                     commit() override;
    void                     revert() override;
    std::size_t              history_bytes() const override;
    void                     save(std::ostream &) const override;
    void                     load(std::istream &) override;

    /// Points of this rank in the trial state.
    std::vector<PointReport> report() const;

    InterfaceSums sums() const;

    /// Seconds spent in search and assembly.
    double seconds = 0.;

  private:
    /// Sums of the trial increment over the points of this rank.
    struct Increment
    {
      double stored = 0., adhesion = 0., friction = 0., impact = 0.,
             external = 0.;
      double front = 0.; ///< [mm^2] decohering now
      double lost  = 0.; ///< [mJ] by decohesion in this increment
    };

    void close_initially();
    void bond_initially();
    void bond_again();
    void assemble_bond(const Configuration &,
                       Assembler &,
                       const unsigned int point);
    void assemble_contact(const Configuration &,
                          Assembler &,
                          const unsigned int point);
    void assemble_friction(const Configuration &,
                           Assembler &,
                           const unsigned int       point,
                           const ContactKinematics &kinematics,
                           dealii::Tensor<1, 3> &   force);
    std::optional<ContactPoint> pair(const Configuration &,
                                     const unsigned int point);
    bool                        may_close(const Configuration &,
                                          const unsigned int  point,
                                          const ContactPoint &found) const;
    void                        count_change(const unsigned int point,
                                             const int          state);

    BoundarySurface             slave;
    ContactSurface              slave_surface;
    Master                      master;
    const InterfaceDescription  description;
    std::vector<SlavePoint>     points;     ///< of this rank
    dealii::IndexSet            all_unknowns; ///< both surfaces
    MPI_Comm                    communicator;
    CandidateSearch             search;
    bool                        search_was_rebuilt = false;
    bool                        first_search       = true;
    std::vector<dealii::Point<3>> x_points; ///< current, of this rank

    std::vector<ContactHistory>  contact, contact_trial;
    std::vector<FrictionHistory> friction, friction_trial;
    std::vector<BondHistory>     bond, bond_trial;
    Increment                    now;
    double                       committed_friction = 0.,
           committed_external = 0., committed_impact = 0.,
           committed_stored = 0.;

    std::vector<bool> just_closed; ///< in the last accepted increment
    std::vector<int> last_state; ///< of the last assembly, theory C.5
    std::vector<std::optional<ContactPoint>> last_pairing;
    unsigned int                             state_changes = 0;
    double                                   last_dt       = 0.;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact, friction and adhesion between slave nodes and master facets.
#ifndef demold_contact_node_to_segment_h
#define demold_contact_node_to_segment_h

#include "contact/contact_kinematics.h"
#include "contact/interface_description.h"
#include "contact/interface_term.h"
#include "contact/point_history.h"
#include "contact/surface_pair.h"
#include "weak_form/softening_sites.h"

namespace demold
{
  /// Node-to-segment contact (thesis 3.1, 5.2): every slave point is held off
  /// the master by the penalty c_N, rubs by the moving friction cone and is
  /// tied to its anchor by the adhesion law (theory C.2, C.3). Forces are per
  /// reference area. The friction weight omega is that of the damage at the
  /// start of the increment; damage with a viscous time grows with the time
  /// that passes for the material. All tangents are exact in the first
  /// iterations, before states are frozen. With a rigid master, mixing with a =
  /// b^2 and no friction they are symmetric.
  class NodeToSegment
    : public InterfaceTerm
    , public SofteningTerm
  {
  public:
    NodeToSegment(BoundarySurface             slave,
                  Master                      master,
                  const InterfaceDescription &description,
                  const dealii::IndexSet     &owned,
                  MPI_Comm                    communicator);

    std::string name() const override;
    TermKind    kind() const override;
    bool        symmetric() const override;
    void        needed_unknowns(dealii::IndexSet &) const override;

    void
    add_couplings(dealii::DynamicSparsityPattern &,
                  const dealii::AffineConstraints<double> &) const override;

    bool           couplings_changed() const override;
    void           prepare(const Configuration &) override;
    bool           assemble(const Configuration &, Assembler &) override;
    unsigned int   n_state_changes() const override;
    IncrementError increment_error() const override;
    std::vector<ClosedPoint> closed_points() const override;
    Energies                 energies() const override;
    void                     commit() override;
    void                     revert() override;
    std::size_t              history_bytes() const override;
    void                     save(std::ostream &) const override;
    void                     load(std::istream &) override;

    std::vector<PointReport> report() const override;
    InterfaceSums            sums() const override;

    std::vector<SofteningSite> softening_sites() const override;
    void                       drive(const std::vector<bool> &points) override;

  private:
    /// Sums of the trial increment over the points of this rank.
    struct Increment
    {
      double front = 0.; ///< [mm^2] decohering now
      double lost  = 0.; ///< [mJ] by decohesion in this increment
    };

    void                      start_point(const unsigned int point);
    void                      bond_on_touch();
    void                      bond_again();
    std::vector<unsigned int> points_that_hold() const;
    AdhesionResponse          respond(const Configuration &,
                                      const unsigned int point,
                                      const AnchorPlace &place);
    void                      assemble_bond(const Configuration &,
                                            Assembler &,
                                            const unsigned int point);
    /// Returns the state, theory C.5: contact, slip or free.
    int  assemble_contact(const Configuration &,
                          Assembler &,
                          const unsigned int point);
    void assemble_pressure(Assembler &,
                           const unsigned int       point,
                           const ContactKinematics &kinematics);
    bool assemble_friction(const Configuration &,
                           Assembler &,
                           const unsigned int       point,
                           const ContactKinematics &kinematics); ///< slips?
    void let_go_of_friction(const unsigned int point);
    void count_change(const unsigned int point, const int state);

    const InterfaceDescription description;
    std::optional<AdhesionLaw> law; ///< of bonds, over the trial increment
    MPI_Comm                   communicator;
    SurfacePair                surfaces;

    PointHistories committed, trial;
    Energies       committed_work; ///< what has been done, and stored, so far
    Energies       now;            ///< in the trial increment; stored: in all
    Increment      increment;

    std::vector<bool> may_bond;    ///< on touch, where the scene lets it
    std::vector<bool> just_closed; ///< in the last accepted increment
    std::vector<int>  last_state;  ///< of the last assembly, theory C.5
    std::vector<AdhesionStatus> last_bond_status;
    std::vector<bool>           driven; ///< by a path; empty: none
    unsigned int                state_changes = 0;
    double                      last_dt       = 0.;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact, friction and adhesion with Lagrange multipliers on common segments.
#ifndef demold_mortar_mortar_term_h
#define demold_mortar_mortar_term_h

#include "contact/interface_term.h"
#include "contact/nodal_force.h"
#include "mortar/eliminated_multiplier.h"
#include "mortar/mortar_operator.h"
#include "mortar/mortar_surfaces.h"
#include "mortar/multiplier_history.h"
#include "mortar/point_constraint.h"
#include "mortar/point_gap.h"
#include "weak_form/softening_sites.h"

#include <functional>
#include <optional>

namespace demold
{
  /// Mortar contact (thesis 3.2, 5.3; theory B, C.4): every slave point has a
  /// multiplier lambda [MPa], the traction on the master; it acts through the
  /// mortar operators and obeys gap = G(lambda + c gap), one constraint for
  /// contact, friction and adhesion, solved together with everything else by
  /// semi-smooth Newton.
  ///
  /// Dual multipliers on a rigid mould can be condensed: lambda is the force
  /// that the rest of the system leaves unbalanced at the node, over D_AA, and
  /// the rows of the node become the constraint; a component with a support, as
  /// on a plane of symmetry, gets no lambda (theory B.11). Points that share
  /// their node with another patch, or whose faces are held or driven
  /// altogether, cannot be treated so: they take a small compliance, so that
  /// their own constraint gives lambda.
  ///
  /// A point that holds a bond uses the operator frozen at bonding, on the
  /// reference configuration: lambda is a nominal traction. All others use the
  /// current segments: lambda is a Cauchy traction.
  class MortarTerm
    : public InterfaceTerm
    , public SofteningTerm
  {
  public:
    /// @p is_held tells whether an unknown has a support.
    MortarTerm(
      BoundarySurface                                             slave,
      Master                                                      master,
      const InterfaceDescription                                 &description,
      const dealii::IndexSet                                     &owned,
      const std::function<bool(dealii::types::global_dof_index)> &is_held,
      MPI_Comm                                                    communicator);

    std::string               name() const override;
    TermKind                  kind() const override;
    bool                      symmetric() const override;
    std::vector<unsigned int> extra_unknown_owners() const override;
    void set_first_extra_unknown(dealii::types::global_dof_index) override;
    void needed_unknowns(dealii::IndexSet &) const override;

    void
    add_couplings(dealii::DynamicSparsityPattern &,
                  const dealii::AffineConstraints<double> &) const override;

    bool           couplings_changed() const override;
    void           prepare(const Configuration &) override;
    bool           assemble(const Configuration &, Assembler &) override;
    void           condense(const Configuration &, CondensedRows &) override;
    unsigned int   n_state_changes() const override;
    bool           has_settled() const override;
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

    /// Unknowns of one point: nodes, then multipliers.
    class LocalSystem;

    /// Standard multipliers whose mean a multiplier takes in the components
    /// that a support leaves undetermined (theory B.11, cross points), but for
    /// what strains its compliance.
    struct Leaning
    {
      std::vector<unsigned int> points; ///< of all ranks
      std::array<bool, 3>       leans = {{false, false, false}};
      dealii::Tensor<2, 3>      share() const; ///< of one of them
    };

    const SlavePoint &point(const unsigned int own) const
    {
      return surfaces.points()[surfaces.own_points()[own]];
    }

    void find_compliance(
      const std::function<bool(dealii::types::global_dof_index)> &is_held);
    void find_compliance(
      const std::function<bool(dealii::types::global_dof_index)> &is_held,
      const unsigned int                                          own,
      const unsigned int                                          d);
    std::vector<unsigned int> neighbours(const unsigned int own) const;
    void                      start_points();
    void                      bond(const unsigned int own);
    void                      bond_again();
    void                      keep_slip_rows();
    std::vector<unsigned int> points_that_hold() const;
    unsigned int              nearest_facet(const unsigned int own) const;

    /// First unknown of the multiplier of a point.
    dealii::types::global_dof_index
    first_unknown_of(const unsigned int point) const;
    dealii::types::global_dof_index first_unknown(const unsigned int own) const;

    dealii::Tensor<1, 3>   multiplier(const Configuration &,
                                      const unsigned int own) const;
    dealii::Tensor<1, 3>   leaned_on(const Configuration &,
                                     const unsigned int own) const;
    std::vector<RowDemand> row_demand(const Configuration &,
                                      const bool with_tangent) const;
    bool                   is_covered(const unsigned int own) const;
    bool is_opposed(const Configuration &, const unsigned int own) const;
    bool holds_at_start(const Configuration &, const unsigned int own) const;
    std::optional<bool> is_pressed(const Configuration &,
                                   const unsigned int own) const;
    bool                touches(const unsigned int own) const;

    PointGap        frozen_gap(const unsigned int own) const;
    PointGap        current_gap(const unsigned int own) const;
    PointGap        gap_of(const unsigned int own) const;
    const NodalRow &row_of(const unsigned int own) const;
    ConstraintInput constraint_input(const Configuration &,
                                     const unsigned int own,
                                     const PointGap    &gap);
    void            assemble_point(const Configuration &,
                                   Assembler &,
                                   const unsigned int own);
    void            assemble_idle(const Configuration &,
                                  Assembler &,
                                  const unsigned int own);
    void            add_force_tangent(const NodalRow             &row,
                                      const dealii::Tensor<1, 3> &traction,
                                      LocalSystem                &local) const;
    void insert(Assembler &, const unsigned int own, const LocalSystem &) const;
    void account(const Configuration &,
                 const unsigned int        own,
                 const ConstraintInput    &input,
                 const ConstraintResponse &response,
                 const PointGap           &gap);
    // Condensed multipliers.
    bool is_condensed() const;
    bool has_own_rows(const unsigned int own) const;
    void condense_point(const Configuration &,
                        CondensedRows &,
                        const unsigned int own);
    void remember_linear(const Configuration &,
                         const CondensedRows &,
                         const unsigned int          own,
                         const dealii::Tensor<1, 3> &balanced,
                         const PointGap             &gap,
                         const NodalUnknowns        &columns);
    void keep_largest(const dealii::Tensor<1, 3> &lambda,
                      const dealii::Tensor<1, 3> &behind);
    dealii::FullMatrix<double>
         direct_dependence(const dealii::Tensor<2, 3>      &dgap,
                           const dealii::Tensor<2, 3>      &dnormal,
                           const dealii::Tensor<1, 3>      &darea,
                           const PointGap                  &gap,
                           const NodalUnknowns             &columns,
                           const std::vector<unsigned int> &components) const;
    void assemble_eliminated(const Configuration &,
                             Assembler &,
                             const unsigned int own);

    void count_change(const unsigned int own, const int number);

    const InterfaceDescription description;
    const MPI_Comm             communicator;
    MortarSurfaces             surfaces;
    MortarOperator             mortar;
    TractionResolvent          resolvent;
    const double stiffness; ///< [MPa/mm] of rows: c_N where none is asked for
    const std::vector<unsigned int>        components; ///< all: 0 to dim - 1
    std::vector<dealii::Tensor<1, 3>>      compliance; ///< [mm/MPa]
    std::vector<Leaning>                   leaning;
    std::vector<std::vector<unsigned int>> free; ///< components without support
    std::vector<bool>                      shared; ///< node, with another patch
    std::vector<bool> driven; ///< all nodes around, in some component
    std::vector<dealii::Tensor<1, 3>> found; ///< lambda [MPa] if condensed
    std::vector<EliminatedMultiplier> eliminated;
    double largest_found    = 0.; ///< [MPa] eliminated lambda
    double largest_accepted = 0.; ///< [MPa] of all increments
    double largest_behind   = 0.; ///< [MPa] what Newton still changes of it
    dealii::types::global_dof_index first_multiplier = 0;

    // One entry per own point.
    std::vector<FrozenRow>         frozen;
    std::vector<NodalRow>          slip_rows; ///< of t_n, where friction acts
    std::vector<MultiplierHistory> committed, trial;
    std::vector<NodalRow>          rows;    ///< of the last assembly
    std::vector<PointNormal>       normals; ///< of the last assembly
    std::vector<NewtonMemory>      newton_memory;
    std::vector<ConstraintInput>   inputs; ///< of the last assembly
    std::vector<bool>              just_closed;
    std::vector<int>               last_number; ///< state of theory C.5

    std::vector<bool> on_path; ///< points that a path drives; empty: none

    Energies     committed_work; ///< what has been done, and stored, so far
    Energies     now;            ///< in the trial increment; stored: in all
    Increment    increment;
    unsigned int state_changes = 0;
    bool         settled       = true;
    double       last_dt       = 0.;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Bonds between nodes of a network.
#ifndef demold_network_bond_links_h
#define demold_network_bond_links_h

#include "contact/point_history.h"
#include "weak_form/softening_sites.h"
#include "weak_form/term.h"

#include <array>

namespace demold
{
  /// A bond that holds node a to node b, normal +y. It does not resist
  /// compression: what may be pressed needs a spring besides.
  struct BondLink
  {
    std::array<dealii::types::global_dof_index, 4> unknowns; ///< ax, ay, bx, by
    double                                         area;     ///< [mm^2]
  };

  /// The adhesion law of section Adhesion at a list of links, which one rank
  /// holds (theory C.2; with a spring in series benchmark E.1).
  class BondLinks
    : public Term
    , public SofteningTerm
  {
  public:
    BondLinks(const AdhesionLaw &law, const std::vector<BondLink> &links);

    std::string name() const override;
    TermKind    kind() const override;
    bool        symmetric() const override;
    void        needed_unknowns(dealii::IndexSet &) const override;
    void
                   add_couplings(dealii::DynamicSparsityPattern &,
                                 const dealii::AffineConstraints<double> &) const override;
    bool           assemble(const Configuration &, Assembler &) override;
    unsigned int   n_state_changes() const override;
    IncrementError increment_error() const override;
    Energies       energies() const override;
    void           commit() override;
    void           revert() override;
    std::size_t    history_bytes() const override;
    void           save(std::ostream &) const override;
    void           load(std::istream &) override;

    std::vector<SofteningSite> softening_sites() const override;
    void                       drive(const std::vector<bool> &points) override;

    /// Area [mm^2] of the bonds that hold, and of all; this rank's share.
    double bonded_area() const;
    double area() const;

  private:
    struct Point
    {
      BondHistory          committed, trial;
      dealii::Tensor<1, 3> gap; ///< [mm] of the last assembly
      AdhesionStatus       last   = AdhesionStatus::adhering; ///< assembly
      double               stored = 0., accepted_stored = 0.; ///< [mJ]
      double taken = 0., accepted_taken = 0.; ///< [mJ] by viscous damage
      bool   driven = false;
    };

    bool             holds(const Point &point) const;
    AdhesionResponse respond(const Point       &point,
                             const unsigned int iteration) const;

    AdhesionLaw                 law; ///< over the trial increment
    const std::vector<BondLink> links;
    std::vector<Point>          points;
    unsigned int                state_changes = 0;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// The term of springs or bars.
#ifndef demold_network_link_term_h
#define demold_network_link_term_h

#include "network/elastic_link.h"
#include "weak_form/assembler.h"
#include "weak_form/term.h"
#include "weak_form/vector_io.h"

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

namespace demold
{
  /// Sum of the energies of a list of links, which one rank holds.
  template <typename Link>
  class LinkTerm : public Term
  {
  public:
    LinkTerm(const std::string &name, std::vector<Link> links)
      : word(name)
      , links(std::move(links))
    {}

    std::string name() const override
    {
      return word;
    }

    TermKind kind() const override
    {
      return TermKind::bulk;
    }

    bool symmetric() const override
    {
      return true;
    }

    void needed_unknowns(dealii::IndexSet &set) const override
    {
      for (const Link &link : links)
        set.add_indices(link.unknowns.begin(), link.unknowns.end());
    }

    void add_couplings(
      dealii::DynamicSparsityPattern          &pattern,
      const dealii::AffineConstraints<double> &constraints) const override
    {
      for (const Link &link : links)
        constraints.add_entries_local_to_global(link.unknowns, pattern, false);
    }

    bool assemble(const Configuration &now, Assembler &assembler) override
    {
      stored = 0.;
      for (const Link &link : links)
        {
          std::vector<double> u;
          for (const auto i : link.unknowns)
            u.push_back(now.u(i));
          const LinkResponse r = link.response(u);
          stored += r.energy;
          if (assembler.with_tangent())
            assembler.add(link.unknowns, r.R, r.K);
          else
            assembler.add(link.unknowns, r.R);
        }
      return true;
    }

    Energies energies() const override
    {
      Energies e;
      e.stored = stored;
      return e;
    }

    void commit() override
    {
      accepted_stored = stored;
    }

    /// Who opens the ledger after a restart asks before any assembly.
    void save(std::ostream &out) const override
    {
      write_values(out, {accepted_stored});
    }

    void load(std::istream &in) override
    {
      accepted_stored = read_values(in).at(0);
      revert();
    }

    void revert() override
    {
      stored = accepted_stored;
    }

    std::size_t history_bytes() const override
    {
      return 0;
    }

  private:
    const std::string       word;
    const std::vector<Link> links;
    double                  stored = 0., accepted_stored = 0.; ///< [mJ]
  };
} // namespace demold

#endif

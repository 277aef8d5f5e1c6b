// SPDX-License-Identifier: LGPL-2.1-or-later
// Which facets a slave node may meet before anything has moved by the skin.
#ifndef demold_contact_candidate_search_h
#define demold_contact_candidate_search_h

#include "contact/contact_surface.h"

#include <vector>

namespace demold
{
  /// Candidate facets per slave node from an R-tree over inflated facet boxes.
  /// The lists stay complete until a node, slave or master, has moved by more
  /// than half the skin, and so does a sparsity pattern made from them.
  class CandidateSearch
  {
  public:
    /// @p reach [mm]: the larger of search distance and depth limit; @p skin
    /// [mm]: larger ones give longer lists and fewer rebuilds. Both >= 0.
    CandidateSearch(const double reach, const double skin);

    /// Are the lists missing, or has a node moved by more than half the skin?
    /// Each rank answers for its own slave nodes; rebuild on all if on any.
    bool is_outdated(const ContactSurface                &master,
                     const std::vector<dealii::Point<3>> &slaves) const;

    /// Finds the candidates of all @p slaves [mm] anew. Every facet within
    /// reach + skin of a slave node is found, some farther ones too.
    void rebuild(const ContactSurface                &master,
                 const std::vector<dealii::Point<3>> &slaves);

    /// Facet numbers for slave node @p slave, ascending.
    const std::vector<unsigned int> &candidates(const unsigned int slave) const
    {
      return facets[slave];
    }

  private:
    double                                 reach;
    double                                 skin;
    bool                                   is_built = false;
    std::vector<dealii::Point<3>>          old_master;
    std::vector<dealii::Point<3>>          old_slaves;
    std::vector<std::vector<unsigned int>> facets;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Mortar integrals of one slave face with all facets opposite.
#ifndef demold_mortar_face_rows_h
#define demold_mortar_face_rows_h

#include "contact/facet.h"
#include "mortar/nodal_row.h"
#include "mortar/pair_gradients.h"

#include <array>
#include <vector>

namespace demold
{
  /// Integrals D and M of the multipliers of one slave face over a list of
  /// nodes: those of the face first, then those of all facets opposite.
  class FaceRows
  {
  public:
    FaceRows(const Facet &face, const bool has_derivatives);

    /// Adds the pair with the facet over @p master_nodes.
    void add(const PairIntegrals<double>       &pair,
             const std::array<unsigned int, 4> &master_nodes);
    void add(const PairGradients               &pair,
             const std::array<unsigned int, 4> &master_nodes);

    /// Turns multipliers shaped as the displacements into dual ones (theory
    /// B.7), after all pairs have been added.
    void make_dual();

    /// Adds the row of node @p a of the face to that of its point: weights -D
    /// and +M.
    void add_to(NodalRow &row, const unsigned int a) const;

  private:
    /// An entry and its derivatives by all nodes.
    struct Entry
    {
      double                            value = 0.;
      std::vector<dealii::Tensor<1, 3>> change;
    };

    unsigned int position(const unsigned int node);
    void         add_changes(const PairGradient              &gradient,
                             const std::vector<unsigned int> &places,
                             Entry                           &entry) const;

    const unsigned int                n_slave;
    std::vector<unsigned int>         nodes;
    const bool                        has_derivatives;
    std::array<std::vector<Entry>, 4> entries; ///< [A][position]
  };
} // namespace demold

#endif

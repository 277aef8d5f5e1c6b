// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces of one slave point and its master nodes on their way to the system.
#ifndef demold_contact_nodal_force_h
#define demold_contact_nodal_force_h

#include "contact/boundary_surface.h"
#include "weak_form/assembler.h"

#include <vector>

namespace demold
{
  /// Unknowns of a list of nodes, and where each is found in local arrays with
  /// three entries per node.
  struct NodalUnknowns
  {
    Assembler::Indices        indices;
    std::vector<unsigned int> entries;

    /// Adds the @p dim unknowns of a node that is number @p position in the
    /// local arrays.
    void add(const BoundarySurface::Node &node,
             const unsigned int           position,
             const unsigned int           dim)
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          indices.push_back(node.unknowns[d]);
          entries.push_back(3 * position + d);
        }
    }
  };

  /// Adds R and K (three entries per node, any array type) times @p area.
  template <typename VectorLike, typename MatrixLike>
  void add_forces(Assembler           &assembler,
                  const NodalUnknowns &unknowns,
                  const double         area,
                  const VectorLike    &R,
                  const MatrixLike    &K)
  {
    const unsigned int     n = unknowns.indices.size();
    dealii::Vector<double> r(n);
    for (unsigned int i = 0; i < n; ++i)
      r(i) = area * R[unknowns.entries[i]];
    if (!assembler.with_tangent())
      {
        assembler.add(unknowns.indices, r);
        return;
      }
    dealii::FullMatrix<double> k(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        k(i, j) = area * K[unknowns.entries[i]][unknowns.entries[j]];
    assembler.add(unknowns.indices, r, k);
  }
} // namespace demold

#endif

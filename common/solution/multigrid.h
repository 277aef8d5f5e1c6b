// SPDX-License-Identifier: LGPL-2.1-or-later
// Smoothed-aggregation multigrid (ML) that knows the rigid-body modes.
#ifndef demold_solution_multigrid_h
#define demold_solution_multigrid_h

#include "weak_form/algebra.h"

#include <deal.II/lac/trilinos_precondition.h>

#include <vector>

namespace demold
{
  /// A V-cycle of smoothed aggregation [Vanek1996], symmetric and positive
  /// definite if the matrix is. It keeps its own copy of the matrix (the
  /// values; the pattern is shared), so that it stays the same operator when
  /// the caller assembles the next matrix into the old one or drops it.
  class Multigrid
  {
  public:
    /// Displacements that cost no energy: 3 translations and 3 rotations of
    /// the nodes, in 2-D 2 and 1, any scale. The @p n_components unknowns of a
    /// node must be consecutive. Empty: each component is a constant.
    void set_rigid_body_modes(const std::vector<Vector> &modes,
                              unsigned int               n_components);

    /// Whether modes were given.
    bool has_modes() const;

    /// Builds the hierarchy for @p matrix, whose rows lie on the ranks as those
    /// of the modes. False if there is none, say for an empty diagonal.
    bool build(const SparseMatrix &matrix);

    bool is_built() const;
    void clear();

    /// y = approximately (matrix built for)^-1 x
    void vmult(Vector &y, const Vector &x) const;

  private:
    std::vector<double>                       null_space; // mode by mode
    unsigned int                              n_modes      = 0;
    unsigned int                              n_components = 1;
    SparseMatrix                              kept_matrix;
    dealii::TrilinosWrappers::PreconditionAMG hierarchy;
    bool                                      built = false;
  };
} // namespace demold

#endif

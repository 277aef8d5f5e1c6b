// SPDX-License-Identifier: LGPL-2.1-or-later
// Smoothed-aggregation multigrid (ML) that knows the rigid-body modes.
#include "solution/multigrid.h"

#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

namespace demold
{
  using namespace dealii;

  void Multigrid::set_rigid_body_modes(const std::vector<Vector> &modes,
                                       const unsigned int n_components_per_node)
  {
    clear();
    n_modes      = modes.size();
    n_components = n_components_per_node;
    null_space.clear();
    for (const Vector &mode : modes)
      null_space.insert(null_space.end(), mode.begin(), mode.end());
  }


  bool Multigrid::has_modes() const
  {
    return n_modes > 0;
  }


  bool Multigrid::build(const SparseMatrix &matrix)
  {
    // First the hierarchy, which points into the matrix.
    clear();
    kept_matrix.copy_from(matrix);

    Teuchos::ParameterList list;
    ML_Epetra::SetDefaults("SA", list);
    list.set("ML output", 0);
    list.set("PDE equations", static_cast<int>(n_components));
    if (has_modes())
      {
        AssertThrow(null_space.size() ==
                      n_modes * matrix.trilinos_matrix().NumMyRows(),
                    ExcMessage("The modes and the matrix differ in their "
                               "number of rows."));
        list.set("null space: type", "pre-computed");
        list.set("null space: dimension", static_cast<int>(n_modes));
        list.set("null space: vectors", null_space.data());
      }
    list.set("aggregation: type", "Uncoupled");
    list.set("smoother: type", "Chebyshev");
    // On a body of its own one is as fast; where a stiff penalty joins two
    // bodies, three need half the iterations and fewer hierarchies.
    list.set("smoother: sweeps", 3);
    list.set("smoother: pre or post", "both");
    list.set("coarse: type", "Amesos-KLU");
    // 5 iterations are enough, 4 treble the Krylov iterations.
    list.set("eigen-analysis: iterations", 8);
    // The eigenvalue estimates start from random vectors: always the same.
    list.set("initialize random seed", true);
    try
      {
        hierarchy.initialize(kept_matrix, list);
        built = true;
      }
    catch (const ExceptionBase &)
      {
        clear();
      }
    return built;
  }


  bool Multigrid::is_built() const
  {
    return built;
  }


  void Multigrid::clear()
  {
    hierarchy.clear();
    kept_matrix.clear();
    built = false;
  }


  void Multigrid::vmult(Vector &y, const Vector &x) const
  {
    hierarchy.vmult(y, x);
  }
} // namespace demold

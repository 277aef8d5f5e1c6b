// SPDX-License-Identifier: LGPL-2.1-or-later
// Direct solution by MUMPS, with inertia and sign of the determinant.
#ifndef demold_solution_mumps_h
#define demold_solution_mumps_h

#include <deal.II/base/mpi.h>

#include <memory>

namespace dealii
{
  namespace TrilinosWrappers
  {
    class SparseMatrix;
    namespace MPI
    {
      class Vector;
    }
  } // namespace TrilinosWrappers
} // namespace dealii

namespace demold
{
  /// Factor of a sparse matrix by MUMPS ([Amestoy2001]), through its C
  /// interface, because the deal.II and Trilinos wrappers hide the symmetric
  /// factor, the inertia and the determinant. Rows may lie non-contiguously
  /// on the ranks (multiplier rows behind the displacements); all ranks
  /// together must hold the rows 0 ... n-1. All calls are collective.
  class Mumps
  {
  public:
    enum class Status
    {
      ok,            ///< factor at hand
      singular,      ///< structurally or numerically; there is no factor
      out_of_memory, ///< even after enlarging the work space
      failed         ///< anything else, see error_code()
    };

    /// @param symmetric  only the lower half is read, factor L D L^T of a
    /// general (also indefinite) symmetric matrix; otherwise L U.
    Mumps(MPI_Comm communicator, bool symmetric);
    ~Mumps();
    Mumps(const Mumps &)            = delete;
    Mumps &operator=(const Mumps &) = delete;

    /// Factorises @p matrix. The ordering is computed at the first call and
    /// whenever the position of an entry (stored zeros included) or the need
    /// for pivoting has changed. The matrix may be destroyed afterwards.
    Status
    analyse_and_factorise(const dealii::TrilinosWrappers::SparseMatrix &matrix);

    /// x = A^-1 b. Both vectors are distributed like the rows of A, without
    /// ghosts, and may be the same object.
    /// @pre the last factorisation was Status::ok
    void solve(dealii::TrilinosWrappers::MPI::Vector       &x,
               const dealii::TrilinosWrappers::MPI::Vector &b);

    /// Number of negative eigenvalues of the factorised matrix (Sylvester);
    /// -1 where it is unknown: unsymmetric, or no factor.
    int n_negative_pivots() const;

    /// Sign of the determinant of the factorised matrix: -1 or 1, and 0 if
    /// the factorisation found it singular.
    int determinant_sign() const;

    /// Memory of the last factorisation, all ranks together [MiB].
    double memory() const;

    /// How often an ordering was computed since construction.
    unsigned int n_analyses() const;

    /// INFOG(1) of the last call to MUMPS (0 is fine); its User's Guide,
    /// section "Error and warning diagnostics", lists the meaning.
    int error_code() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace demold

#endif

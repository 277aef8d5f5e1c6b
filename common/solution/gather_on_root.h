// SPDX-License-Identifier: LGPL-2.1-or-later
// A distributed vector on rank 0, in the order of its global row numbers.
#ifndef demold_solution_gather_on_root_h
#define demold_solution_gather_on_root_h

#include <deal.II/base/mpi.h>

#include <vector>

class Epetra_BlockMap;

namespace demold
{
  /// Collects the pieces of a distributed vector on rank 0 and hands them
  /// back. Rows may lie on the ranks in any order, but all ranks together
  /// must hold the rows 0 ... n-1, each once.
  class GatherOnRoot
  {
  public:
    /// Learns which rows lie where. Collective, as all calls are.
    void reinit(MPI_Comm communicator, const Epetra_BlockMap &rows);

    /// @param piece   this rank's values in the order of its rows
    /// @param vector  rank 0: all values by row number; others: untouched
    void gather(const double *piece, std::vector<double> &vector);

    /// The reverse of gather().
    void scatter(const std::vector<double> &vector, double *piece);

  private:
    MPI_Comm            communicator = MPI_COMM_NULL;
    int                 n_rows       = 0; // of this rank
    std::vector<int>    counts, offsets;  // by rank; this and the rest: rank 0
    std::vector<int>    row_numbers;
    std::vector<double> buffer;
  };
} // namespace demold

#endif

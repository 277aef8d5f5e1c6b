// SPDX-License-Identifier: LGPL-2.1-or-later
// A distributed vector on rank 0, in the order of its global row numbers.
#include "solution/gather_on_root.h"

#include <deal.II/base/exceptions.h>

#include <Epetra_BlockMap.h>

namespace demold
{
  using namespace dealii;

  void GatherOnRoot::reinit(const MPI_Comm comm, const Epetra_BlockMap &rows)
  {
    AssertThrow(rows.MinAllGID() == 0 &&
                  rows.MaxAllGID() + 1 == rows.NumGlobalElements(),
                ExcMessage("The rows must be numbered without holes."));
    communicator = comm;
    n_rows       = rows.NumMyElements();
    counts.resize(Utilities::MPI::n_mpi_processes(communicator));
    offsets.assign(counts.size(), 0);
    MPI_Gather(&n_rows, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, communicator);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        for (std::size_t r = 1; r < counts.size(); ++r)
          offsets[r] = offsets[r - 1] + counts[r - 1];
        row_numbers.resize(rows.NumGlobalElements());
        buffer.resize(row_numbers.size());
      }
    MPI_Gatherv(rows.MyGlobalElements(),
                n_rows,
                MPI_INT,
                row_numbers.data(),
                counts.data(),
                offsets.data(),
                MPI_INT,
                0,
                communicator);
  }


  void GatherOnRoot::gather(const double *piece, std::vector<double> &vector)
  {
    MPI_Gatherv(piece,
                n_rows,
                MPI_DOUBLE,
                buffer.data(),
                counts.data(),
                offsets.data(),
                MPI_DOUBLE,
                0,
                communicator);
    if (!buffer.empty())
      vector.resize(buffer.size());
    for (std::size_t i = 0; i < buffer.size(); ++i)
      vector[row_numbers[i]] = buffer[i];
  }


  void GatherOnRoot::scatter(const std::vector<double> &vector, double *piece)
  {
    for (std::size_t i = 0; i < buffer.size(); ++i)
      buffer[i] = vector[row_numbers[i]];
    MPI_Scatterv(buffer.data(),
                 counts.data(),
                 offsets.data(),
                 MPI_DOUBLE,
                 piece,
                 n_rows,
                 MPI_DOUBLE,
                 0,
                 communicator);
  }
} // namespace demold

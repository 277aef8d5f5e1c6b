// SPDX-License-Identifier: LGPL-2.1-or-later
// The last state on disk, one file per rank, whole or not at all.
#include "scene/checkpoint.h"

#include "base/parameter_error.h"
#include "weak_form/vector_io.h"

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <stdexcept>

namespace demold
{
  using namespace dealii;

  namespace
  {
    std::string rank_file(const std::string &folder, MPI_Comm communicator)
    {
      return folder + "/rank-" +
             std::to_string(Utilities::MPI::this_mpi_process(communicator)) +
             "-of-" +
             std::to_string(Utilities::MPI::n_mpi_processes(communicator)) +
             ".bin";
    }
  } // namespace

  Checkpoint::Checkpoint(const std::string &output_folder,
                         MPI_Comm           communicator)
    : folder(output_folder + "/checkpoint")
    , communicator(communicator)
  {
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::filesystem::remove_all(folder + ".new");
        std::filesystem::create_directories(folder + ".new");
      }
    MPI_Barrier(communicator);
    out.open(rank_file(folder + ".new", communicator), std::ios::binary);
  }

  void Checkpoint::put(const std::vector<double> &values)
  {
    write_values(out, values);
  }

  void Checkpoint::finish()
  {
    out.close();
    const bool good =
      Utilities::MPI::min(out.good() ? 1 : 0, communicator) == 1;
    if (!good)
      throw std::runtime_error("the checkpoint could not be written to " +
                               folder + ".new; is the disk full?");
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::filesystem::remove_all(folder);
        std::filesystem::rename(folder + ".new", folder);
      }
    MPI_Barrier(communicator);
  }

  RestartFile::RestartFile(const std::string &folder, MPI_Comm communicator)
    : in(rank_file(folder, communicator), std::ios::binary)
  {
    const bool good = Utilities::MPI::min(in ? 1 : 0, communicator) == 1;
    if (!good)
      throw ExcParameter("--restart",
                         "needs a checkpoint written by " +
                           std::to_string(
                             Utilities::MPI::n_mpi_processes(communicator)) +
                           " ranks; no " + rank_file(folder, communicator) +
                           ". Restart with the same number of ranks.");
  }

  std::vector<double> RestartFile::get()
  {
    return read_values(in);
  }
} // namespace demold

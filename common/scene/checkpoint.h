// SPDX-License-Identifier: LGPL-2.1-or-later
// The last state on disk, one file per rank, whole or not at all.
#ifndef demold_scene_checkpoint_h
#define demold_scene_checkpoint_h

#include <mpi.h>

#include <fstream>
#include <string>
#include <vector>

namespace demold
{
  /// Writes checkpoint/ in the output folder: first into a folder of its own,
  /// which finish() puts in the place of the last one.
  class Checkpoint
  {
  public:
    Checkpoint(const std::string &output_folder, MPI_Comm communicator);

    std::ostream &stream()
    {
      return out;
    }

    void put(const std::vector<double> &values);

    /// Throws std::runtime_error when the disk is full.
    void finish();

  private:
    const std::string folder;
    const MPI_Comm    communicator;
    std::ofstream     out;
  };

  /// Reads the file of this rank. Throws ExcParameter("--restart", ...) if it
  /// is missing or was written by another number of ranks.
  class RestartFile
  {
  public:
    RestartFile(const std::string &folder, MPI_Comm communicator);

    std::istream &stream()
    {
      return in;
    }

    std::vector<double> get();

  private:
    std::ifstream in;
  };
} // namespace demold

#endif

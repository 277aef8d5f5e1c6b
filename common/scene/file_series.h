// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbered files of one run and the .pvd that gives ParaView their times.
#ifndef demold_scene_file_series_h
#define demold_scene_file_series_h

#include <string>
#include <utility>
#include <vector>

namespace demold
{
  /// Files fields/PREFIXNNNN.vtu in the output folder and NAME.pvd beside that
  /// folder. All ranks keep the same series; the first one writes.
  class FileSeries
  {
  public:
    /// @p prefix of the numbers, may be empty.
    FileSeries(const std::string &output_folder,
               const std::string &name,
               const std::string &prefix);

    /// Full name of the next file; its folder exists afterwards. Collective.
    std::string next_file() const;

    /// The next file has been written for @p time [s]: lists it in the .pvd.
    /// Throws std::runtime_error when the disk is full.
    void add(double time);

    /// Times [s] of all files, for checkpoints.
    std::vector<double> times() const;

    /// Goes on after files of these times. Those that are not in the output
    /// folder keep their numbers but are not listed.
    void restart(const std::vector<double> &times);

  private:
    /// Relative to the output folder.
    std::string file(std::size_t number) const;

    const std::string                           output_folder, name, prefix;
    std::vector<std::pair<double, std::string>> records;
  };
} // namespace demold

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbered files of one run and the .pvd that gives ParaView their times.
#include "scene/file_series.h"

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace demold
{
  using namespace dealii;

  namespace
  {
    bool is_first_rank()
    {
      return Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    }
  } // namespace

  FileSeries::FileSeries(const std::string &output_folder,
                         const std::string &name,
                         const std::string &prefix)
    : output_folder(output_folder)
    , name(name)
    , prefix(prefix)
  {}

  std::string FileSeries::file(const std::size_t number) const
  {
    return "fields/" + prefix + Utilities::int_to_string(number, 4) + ".vtu";
  }

  std::string FileSeries::next_file() const
  {
    if (is_first_rank())
      std::filesystem::create_directories(output_folder + "/fields");
    MPI_Barrier(MPI_COMM_WORLD);
    return output_folder + "/" + file(records.size());
  }

  void FileSeries::add(const double time)
  {
    records.emplace_back(time, file(records.size()));
    if (!is_first_rank())
      return;
    std::vector<std::pair<double, std::string>> present;
    for (const auto &record : records)
      if (std::filesystem::exists(output_folder + "/" + record.second))
        present.push_back(record);
    std::ofstream pvd(output_folder + "/" + name + ".pvd");
    DataOutBase::write_pvd_record(pvd, present);
    pvd.close();
    if (!pvd)
      throw std::runtime_error("could not write " + output_folder + "/" + name +
                               ".pvd; is the disk full?");
  }

  std::vector<double> FileSeries::times() const
  {
    std::vector<double> result;
    for (const auto &record : records)
      result.push_back(record.first);
    return result;
  }

  void FileSeries::restart(const std::vector<double> &times)
  {
    records.clear();
    for (const double time : times)
      records.emplace_back(time, file(records.size()));
  }
} // namespace demold

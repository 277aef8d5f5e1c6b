// SPDX-License-Identifier: LGPL-2.1-or-later
// interface.csv: a row per slave point, as the run has left it.
#include "scene/interface_table.h"

#include "contact/interface_term.h"
#include "output/result_table.h"

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace demold
{
  using namespace dealii;

  namespace
  {
    using Row = std::vector<double>;

    const std::vector<std::string> columns = {"x [mm]",
                                              "y [mm]",
                                              "z [mm]",
                                              "area [mm^2]",
                                              "gap [mm]",
                                              "pressure [MPa]",
                                              "force x [N]",
                                              "force y [N]",
                                              "force z [N]",
                                              "damage [-]",
                                              "bonded [-]",
                                              "state [-]",
                                              "separation time [s]"};

    std::vector<Row> rows_of(const std::vector<PointReport> &points)
    {
      std::vector<Row> rows;
      for (const PointReport &p : points)
        rows.push_back({p.node.X[0],
                        p.node.X[1],
                        p.node.X[2],
                        p.area,
                        p.gap,
                        p.pressure,
                        p.force[0],
                        p.force[1],
                        p.force[2],
                        p.damage,
                        p.bonded ? 1. : 0.,
                        static_cast<double>(p.state),
                        p.separation_time});
      return rows;
    }

    bool is_empty(const unsigned int column, const double value)
    {
      return (columns[column] == "gap [mm]" && value > 1e299) ||
             (columns[column] == "separation time [s]" && value < 0.);
    }
  } // namespace

  void write_interface_table(const std::string   &file,
                             const InterfaceTerm &interface)
  {
    const auto parts =
      Utilities::MPI::gather(MPI_COMM_WORLD, rows_of(interface.report()));
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    std::vector<Row> rows;
    for (const std::vector<Row> &part : parts)
      rows.insert(rows.end(), part.begin(), part.end());
    std::sort(rows.begin(), rows.end());

    ResultTable table(file, columns);
    for (const Row &row : rows)
      {
        std::vector<ResultTable::Value> values;
        for (unsigned int k = 0; k < row.size(); ++k)
          if (is_empty(k, row[k]))
            values.emplace_back(std::string());
          else
            values.emplace_back(row[k]);
        table.add_row(values);
      }
  }
} // namespace demold
